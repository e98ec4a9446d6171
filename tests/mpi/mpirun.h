// Runs lacuna-mpi by mpirun, as a user would. mpirun's own notice of a failure comes after the
// message: its option -q, which silences that, is unknown to Open MPI 5.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "cli/program.h"
#include "text.h"

namespace lacuna::tests::mpi {

inline const std::vector<std::string> kMpirun{"--oversubscribe", "--bind-to", "none"};

// `mpirun` with these arguments; a run of more than a minute is ended, with the exit code 124.
inline std::vector<std::string> command_of(const std::vector<std::string>& arguments) {
    std::vector<std::string> all{"60", LACUNA_MPIRUN};
    all.insert(all.end(), kMpirun.begin(), kMpirun.end());
    all.insert(all.end(), arguments.begin(), arguments.end());
    return all;
}

inline Setting setting() {
    Setting made;
    made.program = "/usr/bin/timeout";
    // All ranks are on this machine and reach each other by the loopback device. If Open MPI 5
    // tried the machine's other networks, too, it might print warnings.
    made.environment = {{"OMPI_ALLOW_RUN_AS_ROOT", "1"},
                        {"OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1"},
                        {"OMPI_MCA_btl_tcp_if_include", "lo"}};
    return made;
}

inline Outcome mpirun(const std::vector<std::string>& arguments) {
    return run(command_of(arguments), setting());
}

// `count` ranks of lacuna-mpi with the same options.
inline std::vector<std::string> ranks(int count, const std::vector<std::string>& options) {
    std::vector<std::string> all{"-n", std::to_string(count), LACUNA_MPI_PROGRAM};
    all.insert(all.end(), options.begin(), options.end());
    return all;
}

// `count` ranks, none of which may write a file larger than `kibibytes` KiB.
inline std::vector<std::string> limited_ranks(int count, int kibibytes,
                                              const std::string& options) {
    return {"-n", std::to_string(count), "/bin/bash", "-c",
            "ulimit -f " + std::to_string(kibibytes) + "; exec " LACUNA_MPI_PROGRAM " " + options};
}

// The ranks of `first`, then the ranks of `then`. Each chooses its command in a shell, because
// mpirun of Open MPI 5.0.7 crashes on the word `:`, which would separate them.
inline std::vector<std::string> joined(const std::vector<std::string>& first,
                                       const std::vector<std::string>& then) {
    const auto command = [](const std::vector<std::string>& ranks) {
        std::string text = "exec";
        for (const std::string& word : std::span(ranks).subspan(2)) text += " '" + word + "'";
        return text;
    };
    const int count = std::stoi(first.at(1)) + std::stoi(then.at(1));
    return {"-n", std::to_string(count), "/bin/bash", "-c",
            "if ((OMPI_COMM_WORLD_RANK < " + first.at(1) + ")); then " + command(first) +
                "; else " + command(then) + "; fi"};
}

}  // namespace lacuna::tests::mpi
