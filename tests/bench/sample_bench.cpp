// Time of whole sets, from request to points, by backend, radius and threads.
//
// The first set of each case is not timed: it pays for what is built at first use.
#include <benchmark/benchmark.h>
#include <lacuna/lacuna.h>

#include <string>

namespace {

using namespace lacuna;

void make_sets(benchmark::State& state, const std::string& backend, double radius,
               std::uint32_t threads) {
    Request request;
    request.radius = radius;
    request.boundary = Boundary::torus;
    request.backend = backend;
    request.threads = threads;
    std::size_t points = 0;
    std::uint64_t rounds = 0;
    try {
        sample(request);
        for (auto _ : state) {
            const Result result = sample(request);
            points = result.points.size();
            rounds = result.rounds;
        }
    } catch (const Unavailable& reason) {
        state.SkipWithError(reason.what());
        return;
    }
    state.counters["points"] = static_cast<double>(points);
    state.counters["rounds"] = static_cast<double>(rounds);
    state.counters["points/s"] = benchmark::Counter(static_cast<double>(points),
                                                    benchmark::Counter::kIsIterationInvariantRate);
}

void add(const std::string& backend, double radius, std::uint32_t threads) {
    std::string name = "lines/" + backend + "/r=" + std::to_string(radius);
    name.erase(name.find_last_not_of('0') + 1);
    if (threads != 0) name += "/threads=" + std::to_string(threads);
    benchmark::RegisterBenchmark(name.c_str(), make_sets, backend, radius, threads)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
}

}  // namespace

int main(int argc, char** argv) {
    for (const std::uint32_t threads : {1u, 2u})
        for (const double radius : {0.05, 0.01, 0.003, 0.001, 0.0003}) add("cpu", radius, threads);
    for (const std::string backend : {"opencl", "vulkan"})
        for (const double radius : {0.01, 0.003, 0.001}) add(backend, radius, 0);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
