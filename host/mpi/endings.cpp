// The ranks agree on how the program ends.
#include "mpi/endings.h"

#include <algorithm>
#include <array>

#include "cli/terminal/run_program.h"

namespace lacuna::mpi {
namespace {

struct Place {
    int rank = 0;
    int ranks = 1;
};

Place place() {
    Place place;
    MPI_Comm_rank(MPI_COMM_WORLD, &place.rank);
    MPI_Comm_size(MPI_COMM_WORLD, &place.ranks);
    return place;
}

}  // namespace

void refuse_another_request(int rank) {
    throw cli::BadUsage("rank " + std::to_string(rank) +
                        " was given another request than rank 0: must be the same on all ranks");
}

void MpiProgram::end_with(const std::optional<Ending>& own) const {
    const auto [rank, ranks] = place();
    const bool fails = own && own->is_answer == 0;
    // The lowest rank that calls fail, the lowest that calls say, the lowest that calls join.
    std::array<int, 3> all{fails ? rank : ranks, own && !fails ? rank : ranks, own ? ranks : rank};
    MPI_Allreduce(MPI_IN_PLACE, all.data(), all.size(), MPI_INT, MPI_MIN, MPI_COMM_WORLD);
    const auto [failing, saying, going_on] = all;
    // All ranks throw this. They agree on the message when run_program() then calls fail().
    if (failing == ranks && saying < ranks && going_on < ranks)
        refuse_another_request(std::max(saying, going_on));
    if (going_on == 0 && failing == ranks) return;
    const int lowest = failing < ranks ? failing : saying;
    Ending ending = own && lowest == rank ? *own : Ending{};
    std::array<int, 3> head{ending.code, ending.is_answer, static_cast<int>(ending.text.size())};
    MPI_Bcast(head.data(), head.size(), MPI_INT, lowest, MPI_COMM_WORLD);
    ending.text.resize(static_cast<std::size_t>(head[2]));
    MPI_Bcast(ending.text.data(), head[2], MPI_CHAR, lowest, MPI_COMM_WORLD);
    agreed_code_ = head[0];
    if (rank != 0) return;
    if (head[1] != 0)
        Program::say(ending.text);
    else
        Program::fail(head[0], ending.text);
}

int MpiProgram::fail(int code, const std::string& message) const {
    const auto [rank, ranks] = place();
    if (are_together_) {
        if (!agreed_code_) end_with(Ending{code, 0, message});
        return exit_code(code);
    }
    Program::fail(code, ranks == 1 ? message : "rank " + std::to_string(rank) + ": " + message);
    MPI_Abort(MPI_COMM_WORLD, code);
    return code;
}

void MpiProgram::say(const std::string& text) const {
    end_with(Ending{0, 1, text});
}

void MpiProgram::join() const {
    end_with({});
    if (agreed_code_) throw cli::CheckFailed();
}

}  // namespace lacuna::mpi
