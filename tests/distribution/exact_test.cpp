// Exact sets have the right counts and the right distribution: counts agree with the jamming limit
// of random sequential adsorption (docs/design.md, section 5), points with dart throwing. The tests
// also notice admission in spatial order, whose sets look just as good.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include <lacuna/lacuna.h>

#include "baseline/dart_throwing.h"
#include "distribution/statistics.h"
#include "plan/make_plan.h"
#include "plan/plan.h"
#include "sampling/generate.h"

namespace {

using namespace lacuna;

constexpr double kRadius = 0.01;
// N r^2 on the torus.
constexpr double kJammed = 0.69656;

#ifdef LACUNA_SPATIAL_ORDER
constexpr bool kIsRight = false;
#else
constexpr bool kIsRight = true;
#endif

Request request_of(Boundary boundary, std::uint64_t round_size) {
    Request request;
    request.mode = Mode::exact;
    request.radius = kRadius;
    request.domain.boundary = boundary;
    request.paper2011.round_size = round_size;
    request.run_on.backend = "cpu";
    return request;
}

std::vector<Sample> samples_of(const Request& request, const Plan& plan) {
    Observer nobody;
    return run_on_backend(request, plan, nobody).outcome.samples;
}

// Counts of maximal sets, seeds 0 up to `seeds`.
tests::Mean mean_count(Request request, std::uint64_t seeds) {
    std::vector<double> counts;
    for (request.seed = 0; request.seed < seeds; ++request.seed)
        counts.push_back(static_cast<double>(samples_of(request, make_plan(request)).size()));
    return tests::mean_of(counts);
}

// Rounds larger than Lacuna would choose make a sharper test: a wrong precedence shows more.
constexpr std::uint64_t kLargeRound = 4000;

struct OnTorus {
    std::uint32_t m;
    std::uint64_t round_size;
};

void PrintTo(const OnTorus& set, std::ostream* out) {
    *out << "m " << set.m << ", round size " << set.round_size;
}

class ExactCounts : public testing::TestWithParam<OnTorus> {};

TEST_P(ExactCounts, AreTheJammingLimits) {
    constexpr std::uint64_t kSeeds = 100;
    Request request = request_of(Boundary::torus, GetParam().round_size);
    request.paper2011.lines_per_radius = GetParam().m;
    const tests::Mean count = mean_count(request, kSeeds);
    const double unit = kRadius * kRadius;
    const double z = (count.value * unit - kJammed) / (count.error * unit);
    std::printf("%s: m %u, round size %lu, N r^2 = %.5f +- %.5f, z %+.2f\n", LACUNA_VARIANT,
                GetParam().m, GetParam().round_size, count.value * unit, count.error * unit, z);
    EXPECT_EQ(std::abs(z) < 3, kIsRight) << z;
    // docs/design.md, section 5: 0.244 sqrt(N); 100 seeds measure it within 7 %.
    const double deviation = count.error * std::sqrt(kSeeds) / std::sqrt(count.value);
    if (kIsRight) {
        EXPECT_NEAR(deviation, 0.244, 0.06);
    }
}

#ifdef LACUNA_SPATIAL_ORDER
const auto kOnTorus = testing::Values(OnTorus{3, kLargeRound}, OnTorus{6, kLargeRound});
#else
const auto kOnTorus = testing::Values(OnTorus{1, 0}, OnTorus{3, 0}, OnTorus{6, 0}, OnTorus{30, 0},
                                      OnTorus{3, kLargeRound}, OnTorus{6, kLargeRound});
#endif

INSTANTIATE_TEST_SUITE_P(OnTheTorus, ExactCounts, kOnTorus, [](const auto& test) {
    const OnTorus& set = test.param;
    return "WithM" + std::to_string(set.m) +
           (set.round_size == 0 ? "" : "InRoundsOf" + std::to_string(set.round_size));
});

// A prefix, as a fraction of the expected maximal count. Dart throwing stops at the same count.
struct Prefix {
    double share;
    std::uint64_t round_size;
};

void PrintTo(const Prefix& prefix, std::ostream* out) {
    *out << prefix.share << ", round size " << prefix.round_size;
}

class ExactSets : public testing::TestWithParam<Prefix> {
protected:
    template <typename Make>
    static tests::Sets make_sets(Request request, std::uint64_t first_seed, Make make) {
        constexpr std::uint64_t kSeeds = 100;
        tests::Sets sets;
        for (request.seed = first_seed; request.seed < first_seed + kSeeds; ++request.seed) {
            const Plan plan = make_plan(request);
            const std::vector<Sample> samples = make(request, plan);
            EXPECT_EQ(samples.size(), *request.limit);
            sets.add(plan, samples, samples.size());
        }
        return sets;
    }

    // Dart throwing's sets up to the request's limit. Made once for a process, in which ctest runs
    // all these tests.
    static const tests::Sets& darts(const Request& request) {
        static std::map<std::uint64_t, tests::Sets> made;
        const auto known = made.find(*request.limit);
        if (known != made.end()) return known->second;
        const auto thrown = [](const Request&, const Plan& plan) {
            return baseline::throw_darts(plan, ~std::uint64_t{0}).samples;
        };
        return made.emplace(*request.limit, make_sets(request, 1000, thrown)).first->second;
    }
};

TEST_P(ExactSets, AreDistributedAsDartThrowings) {
    Request request = request_of(Boundary::torus, GetParam().round_size);
    request.limit = static_cast<std::uint64_t>(GetParam().share * kJammed / (kRadius * kRadius));
    const tests::Verdict verdict = compare(darts(request), make_sets(request, 2000, samples_of));
    std::printf("%s: %s\n", LACUNA_VARIANT, verdict.text().c_str());
    EXPECT_EQ(verdict.same(), kIsRight);
}

#ifndef LACUNA_SPATIAL_ORDER
// The first half is made with one seed, and the set that keeps it with another one.
TEST_P(ExactSets, ThatGoOnFromKeptPointsAreDistributedAsIfTheyHadNeverStopped) {
    const auto going_on = [](Request request, const Plan& plan) {
        Request half = request;
        *half.limit /= 2;
        const Result kept = sample(half);
        request.keep = kept.points;
        request.seed += 1'000'000;
        std::vector<Sample> samples;
        for (const Point& point : sample(request).points)
            samples.push_back({static_cast<std::uint32_t>(point.x * plan.width),
                               static_cast<std::uint32_t>(point.y * plan.height)});
        return samples;
    };
    Request request = request_of(Boundary::torus, GetParam().round_size);
    request.limit = static_cast<std::uint64_t>(GetParam().share * kJammed / (kRadius * kRadius));
    const tests::Verdict verdict = compare(darts(request), make_sets(request, 3000, going_on));
    std::printf("kept: %s\n", verdict.text().c_str());
    EXPECT_TRUE(verdict.same());
}
#endif

#ifdef LACUNA_SPATIAL_ORDER
const auto kPrefixes = testing::Values(Prefix{0.6, kLargeRound}, Prefix{0.9, kLargeRound});
#else
const auto kPrefixes = testing::Values(Prefix{0.6, 0}, Prefix{0.9, 0}, Prefix{0.6, kLargeRound},
                                       Prefix{0.9, kLargeRound});
#endif

INSTANTIATE_TEST_SUITE_P(First, ExactSets, kPrefixes, [](const auto& test) {
    const Prefix& prefix = test.param;
    return std::to_string(static_cast<int>(std::round(100 * prefix.share))) + "PercentInRoundsOf" +
           (prefix.round_size == 0 ? "AutomaticSize" : std::to_string(prefix.round_size));
});

#ifndef LACUNA_SPATIAL_ORDER
TEST(ExactCountsInTheBox, FollowTheirFormula) {
    struct Box {
        double width;
        double height;
        double radius;
    };
    constexpr std::uint64_t kSeeds = 100;
    for (const Box box : {Box{1, 1, 0.01}, Box{1, 1, 0.05}, Box{2, 0.3, 0.02}, Box{0.2, 1, 0.01}}) {
        Request request = request_of(Boundary::box, 0);
        request.domain.width = box.width;
        request.domain.height = box.height;
        request.radius = box.radius;
        const double expected =
            0.69655 * (box.width / box.radius + 0.666) * (box.height / box.radius + 0.666);
        const tests::Mean count = mean_count(request, kSeeds);
        const double z = (count.value - expected) / count.error;
        std::printf("%g x %g, r = %g: N = %.2f +- %.2f, expected %.2f, z %+.2f\n", box.width,
                    box.height, box.radius, count.value, count.error, expected, z);
        EXPECT_LT(std::abs(z), 3);
    }
}
#endif

}  // namespace
