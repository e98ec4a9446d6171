// Rounds do not change the distribution: sets made in rounds of many draws against sets made one
// sample at a time, as in the paper. And the tests have teeth: they notice admission in spatial
// order, which looks just as good.
#include <gtest/gtest.h>

#include <cstdio>

#include "backends/backends.h"
#include "distribution/statistics.h"
#include "plan/plan.h"

namespace {

using namespace lacuna;

constexpr std::uint64_t kSeeds = 100;

// Statistics of the first `share` of the points of each set; counts are of the whole sets.
tests::Sets make_sets(const std::string& backend, std::uint64_t round_size,
                      std::uint64_t first_seed, double share) {
    tests::Sets sets;
    Request request;
    request.mode = Mode::lines;
    request.radius = 0.01;
    request.boundary = Boundary::torus;
    request.backend = backend;
    request.round_size = round_size;
    for (request.seed = first_seed; request.seed < first_seed + kSeeds; ++request.seed) {
        const Plan plan = make_plan(request);
        Observer nobody;
        std::vector<Sample> samples = run_on_backend(request, plan, nobody).outcome.samples;
        const std::size_t count = samples.size();
        samples.resize(static_cast<std::size_t>(share * static_cast<double>(count)));
        sets.add(plan, samples, count);
    }
    return sets;
}

// Larger rounds than Lacuna would choose make for a sharper test: a wrong precedence shows more.
struct Case {
    std::uint64_t round_size;
    double share;
};

void PrintTo(const Case& set, std::ostream* out) {
    *out << set.round_size << ", " << set.share;
}

class Rounds : public testing::TestWithParam<Case> {};

TEST_P(Rounds, LeaveTheDistributionAsItIs) {
    const auto [round_size, share] = GetParam();
    const tests::Verdict verdict =
        compare(make_sets("reference", 1, 1000, share), make_sets("cpu", round_size, 2000, share));
    std::printf("%s: %s\n", LACUNA_VARIANT, verdict.text().c_str());
#ifdef LACUNA_SPATIAL_ORDER
    EXPECT_FALSE(verdict.same());
#else
    EXPECT_TRUE(verdict.same());
#endif
}

#ifdef LACUNA_SPATIAL_ORDER
// Rounds that lose a fifth of their draws show the bias only in more sets than 100.
const auto kCases = testing::Values(Case{4000, 1.0}, Case{4000, 0.6});
#else
const auto kCases = testing::Values(Case{0, 1.0}, Case{0, 0.6}, Case{7, 1.0}, Case{7, 0.6},
                                    Case{4000, 1.0}, Case{4000, 0.6});
#endif

INSTANTIATE_TEST_SUITE_P(Sets, Rounds, kCases, [](const auto& test) {
    const Case& set = test.param;
    return "Of" + (set.round_size == 0 ? "AutomaticSize" : std::to_string(set.round_size)) +
           (set.share == 1.0 ? "Whole" : "First60Percent");
});

}  // namespace
