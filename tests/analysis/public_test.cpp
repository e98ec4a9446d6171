// Given sets, the public header returns their statistics.
#include <gtest/gtest.h>
#include <lacuna/analysis.h>

#include <cstdint>
#include <vector>

namespace {

using namespace lacuna;

std::vector<Point> maximal_set(std::uint64_t seed) {
    Request request;
    request.radius = 0.03;
    request.domain.boundary = Boundary::torus;
    request.place.backend = "cpu";
    request.seed = seed;
    return sample(request).points;
}

TEST(Analyze, OfMaximalSetsFindsWhatTheyAreKnownFor) {
    const std::vector<std::vector<Point>> sets{maximal_set(1), maximal_set(2)};
    const Statistics statistics = analyze(sets, {1, 1, Boundary::torus});
    EXPECT_NEAR(statistics.mean_count, 774, 20);  // 0.69656 / r^2
    ASSERT_TRUE(statistics.least_distance && statistics.mean_distance);
    EXPECT_GE(*statistics.least_distance, 0.03);
    EXPECT_NEAR(*statistics.mean_distance, 1.0538 * 0.03, 0.0005);
    ASSERT_FALSE(statistics.rings.empty());
    EXPECT_LT(statistics.rings.front().power, 0.3);
    EXPECT_GT(statistics.rings.back().frequency, 1.9);
    EXPECT_NEAR(statistics.effective_nyquist.value(), 0.67, 0.05);
    EXPECT_FALSE(statistics.pair_correlation.empty());
    EXPECT_NEAR(statistics.psi_6.value(), 0.43, 0.04);
}

TEST(Analyze, RefusesSetsThatMakeNoSenseAndCanBeEnded) {
    std::vector<std::vector<Point>> sets;
    EXPECT_THROW(analyze(sets), BadRequest);
    sets.emplace_back();
    EXPECT_THROW(analyze(sets), BadRequest);
    sets[0] = {{0.5, 1.5}};
    EXPECT_THROW(analyze(sets), BadRequest);
    sets[0] = maximal_set(1);
    EXPECT_THROW(analyze(sets, {1, 1, Boundary::torus}, [](double) { return false; }), Cancelled);
}

}  // namespace
