// The options of `lacuna-mpi sample`, and its run.
#include "mpi/sample.h"

#include <fmt/core.h>
#include <mpi.h>
#include <sched.h>
#include <unistd.h>

#include <lacuna/lacuna.h>
#include <lacuna/version.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "base/number_text.h"
#include "cli/options/bind.h"
#include "cli/options/common_options.h"
#include "cli/reports/output.h"
#include "cli/reports/report.h"
#include "cli/terminal/driver.h"
#include "cli/terminal/observers.h"
#include "cli/terminal/progress_bar.h"
#include "cli/terminal/run_program.h"
#include "files/point_files.h"
#include "mpi/mpi_ranks.h"
#include "mpi/npy_sink.h"
#include "mpi/report.h"
#include "plan/sizes.h"
#include "ranks/sample_on_ranks.h"
#include "ranks/together.h"

namespace lacuna::mpi {
namespace {

constexpr const char* kSampleDescription =
    R"(Makes a blue-noise point set on all ranks, the same as lacuna sample --mode exact.

Examples:
  mpirun -n 4 lacuna-mpi sample --radius 0.0001 --torus -o points.npy
  mpirun -n 64 lacuna-mpi sample --count 1e9 --torus --seed 7 -o points.npy --report cost.json
)";

struct Machine {
    std::uint32_t ranks = 1;         // on this machine, among which its cores are divided
    std::uint64_t memory_bytes = 0;  // of all machines together
};

Machine look_at_machines(MPI_Comm communicator) {
    MPI_Comm here = MPI_COMM_NULL;
    MPI_Comm_split_type(communicator, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &here);
    int ranks = 1;
    int rank = 0;
    MPI_Comm_size(here, &ranks);
    MPI_Comm_rank(here, &rank);
    MPI_Comm_free(&here);
    Machine machine{static_cast<std::uint32_t>(ranks), rank == 0 ? machine_memory_bytes() : 0};
    MPI_Allreduce(MPI_IN_PLACE, &machine.memory_bytes, 1, MPI_UINT64_T, MPI_SUM, communicator);
    return machine;
}

// One thread for each core that mpirun binds this rank to, but no more than the machine's cores
// divided by its ranks.
std::uint32_t threads_for(const Machine& machine) {
    cpu_set_t mine{};
    const bool is_known = sched_getaffinity(0, sizeof(mine), &mine) == 0;
    const auto all = static_cast<std::uint32_t>(std::max(1L, sysconf(_SC_NPROCESSORS_ONLN)));
    const std::uint32_t bound = is_known ? static_cast<std::uint32_t>(CPU_COUNT(&mine)) : all;
    return std::max(1u, std::min(bound, all / machine.ranks));
}

struct MpiSample {
    cli::CommonOptions common;
    std::string path;
    bool progress = false;
};

void check(const MpiSample& all, const Request& request, const MpiRanks& ranks) {
    if (all.path.empty())
        throw BadRequest("output", "nothing", "must be given: a file whose name ends in .npy");
    const files::Format* const format = files::find_format_of(all.path);
    if (cli::is_stream(all.path) || format == nullptr || format->extension != ".npy")
        throw BadRequest("output", shown(all.path),
                         "must be a file whose name ends in .npy, to which all ranks can write");
    cli::check_writable(all.path);
    if (!all.common.report.empty()) cli::check_json("report", all.common.report);
    check_request_on_ranks(request);
    const std::uint32_t most = most_ranks(request);
    if (ranks.count() > most)
        throw cli::BadUsage(fmt::format(
            "{} ranks are too many for this radius: at most {}, each with two radii of the width",
            ranks.count(), most));
}

// Compares a hash (FNV-1a) of all options that must be the same on all ranks.
void check_same_everywhere(const MpiSample& all, const MpiRanks& ranks) {
    const Request& request = all.common.request;
    const std::string said = cli::what_decides(request, {}).dump() + "\n" + all.path + "\n" +
                             all.common.report + "\n" + LACUNA_VERSION;
    std::uint64_t own = 0xcbf29ce484222325;
    for (const char c : said) own = (own ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    std::uint64_t first = own;
    MPI_Bcast(&first, 1, MPI_UINT64_T, 0, ranks.communicator());
    if (own != first) refuse_another_request(static_cast<int>(ranks.rank()));
}

// Watches the run; the progress bar is shown by rank 0 only.
class Watch {
public:
    Watch(const MpiSample& all, bool speaks)
        : driver_(all.common.request.run_on.backend),
          stopwatch_(!all.common.report.empty()),
          bar_(all.common.quiet || !speaks, all.progress) {}
    cli::Observers& observers() { return observers_; }
    const cli::Stopwatch& stopwatch() const { return stopwatch_; }

private:
    cli::DriverAtWork driver_;
    cli::Stopwatch stopwatch_;
    cli::ProgressBar bar_;
    cli::Observers observers_{{driver_, stopwatch_, bar_}};
};

void sum_up(const MpiSample& all, const ResultOnRanks& result, double seconds,
            std::uint32_t ranks) {
    const std::uint64_t rounds = result.outcome.rounds;
    const std::string size =
        (all.common.request.count ? fmt::format(", radius {:.4g}", result.radius) : "") +
        (result.outcome.maximal ? "" : ", not maximal");
    const std::string line = fmt::format(
        "{} point{}{}, {} round{}, {:.3f} s, {} on {} rank{} -> {}", result.outcome.samples,
        result.outcome.samples == 1 ? "" : "s", size, rounds, rounds == 1 ? "" : "s", seconds,
        result.backend, ranks, ranks == 1 ? "" : "s", all.path);
    std::fputs((cli::printable(line) + "\n").c_str(), stderr);
}

void write_report(const MpiSample& all, const std::string& report, bool is_its_turn,
                  MpiRanks& ranks) {
    together(ranks, [&] {
        if (is_its_turn && !report.empty()) files::write_whole(all.common.report, report);
    });
}

// Makes and writes the set on all ranks. An error that is not FailedTogether ends all other ranks.
void make(const MpiSample& all, const Request& request, MpiRanks& ranks) {
    const bool speaks = ranks.rank() == 0;
    NpySink sink(all.path, ranks);
    try {
        ResultOnRanks result;
        double seconds = 0;
        Watch watch(all, speaks);
        result = sample_on_ranks(request, ranks, sink, watch.observers());
        sink.finish();
        seconds = watch.stopwatch().seconds_so_far();
        std::string report;
        if (!all.common.report.empty())
            report = report_of(request, result, watch.stopwatch(), seconds, ranks, sink,
                               speaks ? sink.sha256() : "");
        // In lacuna's order: a report that is a file, the set, a report that is a stream.
        const bool is_streamed = cli::is_stream(all.common.report);
        write_report(all, report, speaks && !is_streamed, ranks);
        sink.put_in_place();
        write_report(all, report, speaks && is_streamed, ranks);
        const bool is_quiet = all.common.quiet || cli::is_standard_output(all.common.report);
        if (speaks && !is_quiet) sum_up(all, result, seconds, ranks.count());
    } catch (const FailedTogether&) {
        sink.close();
        throw;
    }
}

void run(const MpiSample& all, const MpiProgram& program) {
    program.join();  // all ranks have understood their options
    MpiRanks ranks(MPI_COMM_WORLD);
    const Machine machine = look_at_machines(ranks.communicator());
    Request request = all.common.request;
    if (request.run_on.threads == 0) request.run_on.threads = threads_for(machine);
    if (request.run_on.memory_limit_bytes == 0)
        request.run_on.memory_limit_bytes = machine.memory_bytes;
    check_same_everywhere(all, ranks);
    check(all, request, ranks);
    program.join();
    program.part();
    try {
        make(all, request, ranks);
    } catch (const FailedTogether& failed) {
        program.meet();
        if (failed.own) std::rethrow_exception(failed.own);
        program.join();
    }
    program.meet();
}

}  // namespace

void add_sample(CLI::App& app, const MpiProgram* const& program) {
    const auto all = std::make_shared<MpiSample>();
    cli::Targets targets{{"output", &all->path},
                         {"report", &all->common.report},
                         {"progress", &all->progress},
                         {"quiet", &all->common.quiet}};
    targets.merge(options::targets_of(all->common.request));
    cli::add_command(app, options::kMpiSample, kSampleDescription, targets,
                     [all, &program](const cli::CommandLine&) { run(*all, *program); });
}

}  // namespace lacuna::mpi
