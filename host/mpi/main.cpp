// The command lacuna-mpi: the ranks of one MPI program make one set.
#include <mpi.h>
#include <signal.h>

#include <CLI/App.hpp>

#include "mpi/endings.h"
#include "mpi/sample.h"

namespace {

constexpr const char* kDescription = R"(Makes blue-noise point sets on many machines.

Examples:
  mpirun -n 4 lacuna-mpi sample --count 1e8 --torus -o points.npy
  lacuna-mpi sample --help
)";

}  // namespace

int main(int argc, char** argv) {
    // MPI_Init makes files in shared memory. If they exceed `ulimit -f`, a write then fails with an
    // error; otherwise SIGXFSZ would end the program without a message.
    signal(SIGXFSZ, SIG_IGN);
    int provided = 0;
    // oneTBB's threads compute; only this thread calls MPI.
    MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
    const lacuna::mpi::MpiProgram* program = nullptr;
    const lacuna::mpi::MpiProgram lacuna_mpi("lacuna-mpi", kDescription, [&program](CLI::App& app) {
        lacuna::mpi::add_sample(app, program);
    });
    program = &lacuna_mpi;
    const int code = lacuna_mpi.exit_code(lacuna::cli::run_program(lacuna_mpi, argc, argv));
    MPI_Finalize();
    return code;
}
