// Rounds do not change the distribution: sets made in rounds of many draws against sets made one
// sample at a time, as in the paper. The tests also notice admission in spatial order, whose sets
// look just as good.
#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "distribution/statistics.h"
#include "plan/make_plan.h"
#include "plan/plan.h"
#include "sampling/generate.h"

namespace rounds_test {

using namespace lacuna;

constexpr std::uint64_t kSeeds = 100;

constexpr double kFirst = 0.6;

// The same sets twice: with all points, and with the first ones. Counts are of whole sets in both.
struct Group {
    tests::Sets whole;
    tests::Sets first;

    const tests::Sets& of(double share) const { return share == kFirst ? first : whole; }
};

Group made_group(const std::string& backend, std::uint64_t round_size, std::uint64_t first_seed) {
    Group group;
    Request request;
    request.mode = Mode::lines;
    request.radius = 0.01;
    request.domain.boundary = Boundary::torus;
    request.run_on.backend = backend;
    request.paper2011.round_size = round_size;
    for (request.seed = first_seed; request.seed < first_seed + kSeeds; ++request.seed) {
        const Plan plan = make_plan(request);
        Observer nobody;
        std::vector<Sample> samples = run_on_backend(request, plan, nobody).outcome.samples;
        const std::size_t count = samples.size();
        group.whole.add(plan, samples, count);
        samples.resize(static_cast<std::size_t>(kFirst * static_cast<double>(count)));
        group.first.add(plan, samples, count);
    }
    return group;
}

// Made once for a process, in which ctest runs all tests of rounds.
const Group& group_of(const std::string& backend, std::uint64_t round_size,
                      std::uint64_t first_seed) {
    static std::map<std::tuple<std::string, std::uint64_t, std::uint64_t>, Group> made;
    const std::tuple key(backend, round_size, first_seed);
    const auto known = made.find(key);
    if (known != made.end()) return known->second;
    return made.emplace(key, made_group(backend, round_size, first_seed)).first->second;
}

// Rounds larger than Lacuna would choose make a sharper test: a wrong precedence shows more.
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
    const tests::Verdict verdict = compare(group_of("reference", 1, 1000).of(share),
                                           group_of("cpu", round_size, 2000).of(share));
    std::printf("%s: %s\n", LACUNA_VARIANT, verdict.text().c_str());
#ifdef LACUNA_SPATIAL_ORDER
    EXPECT_FALSE(verdict.same());
#else
    EXPECT_TRUE(verdict.same());
#endif
}

#ifdef LACUNA_SPATIAL_ORDER
// With rounds that lose a fifth of their draws, 100 sets are too few to show the bias.
const auto kCases = testing::Values(Case{4000, 1.0}, Case{4000, kFirst});
#else
const auto kCases = testing::Values(Case{0, 1.0}, Case{0, kFirst}, Case{7, 1.0}, Case{7, kFirst},
                                    Case{4000, 1.0}, Case{4000, kFirst});
#endif

INSTANTIATE_TEST_SUITE_P(Sets, Rounds, kCases, [](const auto& test) {
    const Case& set = test.param;
    return "Of" + (set.round_size == 0 ? "AutomaticSize" : std::to_string(set.round_size)) +
           (set.share == 1.0 ? "Whole" : "First60Percent");
});

}  // namespace rounds_test
