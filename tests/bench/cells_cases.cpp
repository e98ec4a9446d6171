// Time of stipples, from importance to exactly N points, including the pilot that finds the scale:
// cells/BACKEND/raccoon/N=.../m=.../threads=... The picture was read before.
#include "cells_cases.h"

#ifdef LACUNA_RACCOON
#include <benchmark/benchmark.h>
#include <lacuna/lacuna.h>

#include <cstdint>
#include <sstream>
#include <string>

#include "fields.h"

namespace lacuna::bench {
namespace {

void make_stipples(benchmark::State& state, const Request& described) {
    static const Field raccoon = tests::raccoon_field(1024);
    Request request = described;
    request.field = &raccoon;
    Result result;
    try {
        result = sample(request);
        for (auto _ : state) result = sample(request);
    } catch (const Unavailable& reason) {
        state.SkipWithError(reason.what());
        return;
    }
    state.counters["points"] = static_cast<double>(result.points.size());
    state.counters["rounds"] = static_cast<double>(result.rounds);
    state.counters["points/s"] = benchmark::Counter(static_cast<double>(result.points.size()),
                                                    benchmark::Counter::kIsIterationInvariantRate);
}

void add(const std::string& backend, std::uint64_t count, std::uint32_t m, Metric metric,
         std::uint32_t threads) {
    Request request;
    request.mode = Mode::cells;
    request.domain.width = 4;
    request.domain.height = 3;
    request.count = count;
    request.paper2011.lines_per_radius = m;
    request.metric = metric;
    request.run_on.backend = backend;
    request.run_on.threads = threads;
    std::ostringstream name;
    name << "cells/" << backend << "/raccoon/N=" << count << "/m=" << m;
    if (metric != Metric::min) name << "/" << name_of(metric);
    if (threads != 0) name << "/threads=" << threads;
    benchmark::RegisterBenchmark(name.str().c_str(), make_stipples, request)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
}

}  // namespace

void add_cells_cases() {
    for (const std::uint32_t threads : {1u, 2u})
        for (const std::uint64_t count : {20'000u, 250'000u})
            for (const std::uint32_t m : {10u, 30u}) add("cpu", count, m, Metric::min, threads);
    for (const Metric metric : {Metric::mean, Metric::max}) add("cpu", 20'000, 10, metric, 2);
    for (const std::string backend : {"opencl", "vulkan"})
        for (const std::uint64_t count : {20'000u, 250'000u})
            for (const std::uint32_t m : {10u, 30u}) add(backend, count, m, Metric::min, 0);
}

}  // namespace lacuna::bench

#else
void lacuna::bench::add_cells_cases() {}
#endif
