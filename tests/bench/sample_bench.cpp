// Time of whole sets, from request to points, by mode, backend, radius and threads; and their
// memory: the peak beyond the points themselves, in bytes a point.
//
// The first set of each case is not timed: it pays for everything built at first use. Sets of 10
// and 100 million points run only when the filter names them, once: --benchmark_filter=large/; sets
// of large/verify are also proven maximal, and the proof is timed too.
#include <benchmark/benchmark.h>
#include <lacuna/lacuna.h>
#include <lacuna/verify.h>

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "cli/reports/peak_memory.h"

#include "cells_cases.h"

namespace {

using namespace lacuna;

Request torus(Mode mode, const std::string& backend, double radius, std::uint32_t threads) {
    Request request;
    request.mode = mode;
    request.radius = radius;
    request.domain.boundary = Boundary::torus;
    request.run_on.backend = backend;
    request.run_on.threads = threads;
    return request;
}

// The most memory that the process held while the set was made, beyond what it held before.
double bytes_of(const cli::PeakMemory& peak) {
    const auto bytes = peak.raised_bytes();
    return bytes ? static_cast<double>(*bytes) : std::nan("");
}

void count(benchmark::State& state, const Result& result, double peak_bytes) {
    const auto points = static_cast<double>(result.points.size());
    state.counters["points"] = points;
    state.counters["rounds"] = static_cast<double>(result.rounds);
    state.counters["bytes/point"] = peak_bytes / points - sizeof(Point);
    state.counters["points/s"] =
        benchmark::Counter(points, benchmark::Counter::kIsIterationInvariantRate);
}

void make_sets(benchmark::State& state, const Request& request) {
    try {
        const cli::PeakMemory peak;
        Result result = sample(request);
        const double peak_bytes = bytes_of(peak);
        for (auto _ : state) result = sample(request);
        count(state, result, peak_bytes);
    } catch (const Unavailable& reason) {
        state.SkipWithError(reason.what());
    }
}

void make_one_set(benchmark::State& state, const Request& request) {
    for (auto _ : state) {
        const cli::PeakMemory peak;
        const Result result = sample(request);
        count(state, result, bytes_of(peak));
    }
}

void verify_one_set(benchmark::State& state, const Request& request) {
    const std::vector<Point> points = sample(request).points;
    Claim claim;
    claim.radius = *request.radius;
    claim.domain.boundary = request.domain.boundary;
    bool is_proven = false;
    for (auto _ : state) is_proven = prove(points, claim).maximal;
    state.counters["points"] = static_cast<double>(points.size());
    if (!is_proven) state.SkipWithError("the set is not maximal");
}

std::string name_of(const std::string& what, const std::string& radius, std::uint32_t threads) {
    return what + "/r=" + radius + (threads == 0 ? "" : "/threads=" + std::to_string(threads));
}

void add(Mode mode, const std::string& backend, const std::string& radius, std::uint32_t threads) {
    const std::string what = std::string(lacuna::name_of(mode)) + "/" + backend;
    benchmark::RegisterBenchmark(name_of(what, radius, threads).c_str(), make_sets,
                                 torus(mode, backend, std::stod(radius), threads))
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
}

// About 10 and 100 million points.
void add_large() {
    const auto once = [](benchmark::internal::Benchmark* one) {
        one->Iterations(1)->Unit(benchmark::kSecond)->UseRealTime();
    };
    for (const std::string radius : {"0.000264", "0.0000835"}) {
        for (const std::uint32_t threads : {1u, 2u}) {
            once(benchmark::RegisterBenchmark(
                name_of("large/exact/cpu", radius, threads).c_str(), make_one_set,
                torus(Mode::exact, "cpu", std::stod(radius), threads)));
        }
        once(benchmark::RegisterBenchmark(name_of("large/verify", radius, 0).c_str(),
                                          verify_one_set,
                                          torus(Mode::exact, "cpu", std::stod(radius), 0)));
    }
}

}  // namespace

int main(int argc, char** argv) {
    for (const Mode mode : {Mode::lines, Mode::exact}) {
        for (const std::uint32_t threads : {1u, 2u})
            for (const std::string radius :
                 {"0.05", "0.01", "0.005", "0.003", "0.001", "0.0005", "0.0003"})
                add(mode, "cpu", radius, threads);
        for (const std::string backend : {"opencl", "vulkan"})
            for (const std::string radius : {"0.05", "0.01", "0.003", "0.001"})
                add(mode, backend, radius, 0);
    }
    for (int i = 1; i < argc; ++i) {
        const std::string_view argument = argv[i];
        if (argument.starts_with("--benchmark_filter=") &&
            argument.find("large") != std::string_view::npos)
            add_large();
    }
    bench::add_cells_cases();
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
