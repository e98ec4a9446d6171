// Run by mpirun with any number of ranks: for 60 requests, and some for each device, the file that
// the ranks write together holds the points of lacuna::sample. Exits with 0 if all do.
#include <mpi.h>

#include <lacuna/files.h>
#include <lacuna/lacuna.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "files/point_files.h"
#include "files/read_whole.h"
#include "mpi/mpi_ranks.h"
#include "mpi/npy_sink.h"
#include "mpi/requests.h"
#include "ranks/sample_on_ranks.h"
#include "required.h"

namespace {

using namespace lacuna;

// As many ranks as the request has room for make the set; returns on rank 0 whether it is the same.
bool is_same(const Request& request, const std::string& path, int& ranks_used) {
    int rank = 0;
    int ranks = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    const int used = std::min(ranks, static_cast<int>(most_ranks(request)));
    ranks_used = std::max(ranks_used, used);
    MPI_Comm some = MPI_COMM_NULL;
    MPI_Comm_split(MPI_COMM_WORLD, rank < used ? 0 : MPI_UNDEFINED, rank, &some);
    if (some == MPI_COMM_NULL) return true;
    bool same = true;
    {
        Observer nobody;
        mpi::MpiRanks own(some);
        mpi::NpySink sink(path, own);
        const ResultOnRanks made = sample_on_ranks(request, own, sink, nobody);
        sink.finish();
        const std::string sha256 = rank == 0 ? sink.sha256() : "";
        sink.put_in_place();
        if (rank == 0) {
            Request alone = request;
            alone.run_on.backend = "cpu";
            const Result expected = sample(alone);
            same = sha256 == files::sha256_of(expected.points) &&
                   made.outcome.samples == expected.points.size() &&
                   made.outcome.maximal == expected.maximal && made.radius == expected.radius;
            // Compares the whole file, including its header.
            const std::string whole =
                files::encode({expected.points, request.domain}, *files::find_format("npy"));
            same = same && files::read_whole(path) == whole;
        }
    }
    MPI_Comm_free(&some);
    return same;
}

bool has(const std::string& backend) {
    const std::vector<Device> all = devices();
    return lacuna::tests::is_required(backend) ||
           std::any_of(all.begin(), all.end(), [&](const Device& device) {
               return device.backend == backend && device.unusable.empty();
           });
}

}  // namespace

int main(int argc, char** argv) {
    MPI_Init(&argc, &argv);
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    const std::string path = argc > 1 ? argv[1] : "equality.npy";
    int compared = 0;
    int different = 0;
    int ranks_used = 0;
    const std::vector<Request> requests = tests::requests_for_ranks();
    const auto compare = [&](Request request, const std::string& backend, std::size_t number) {
        request.run_on.backend = backend;
        ++compared;
        if (is_same(request, path, ranks_used)) return;
        ++different;
        std::fprintf(stderr, "request %zu on %s: another set than lacuna::sample's\n", number,
                     backend.c_str());
    };
    for (std::size_t i = 0; i < requests.size(); ++i) compare(requests[i], "cpu", i);
    for (const std::string backend : {"opencl", "vulkan"}) {
        int there = rank == 0 && has(backend) ? 1 : 0;
        MPI_Bcast(&there, 1, MPI_INT, 0, MPI_COMM_WORLD);
        for (std::size_t i = 0; there != 0 && i < requests.size(); i += 13)
            compare(requests[i], backend, i);
    }
    if (rank == 0) {
        std::filesystem::remove(path);
        std::printf("%d sets on up to %d ranks, %d different\n", compared, ranks_used, different);
    }
    MPI_Finalize();
    return different == 0 && requests.size() >= 60 ? 0 : 1;
}
