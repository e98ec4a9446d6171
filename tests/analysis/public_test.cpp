// Given sets, the public header returns their statistics.
#include <gtest/gtest.h>
#include <lacuna/analysis.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace {

using namespace lacuna;

std::vector<Point> maximal_set(std::uint64_t seed) {
    Request request;
    request.radius = 0.03;
    request.domain.boundary = Boundary::torus;
    request.run_on.backend = "cpu";
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

TEST(Analyze, DoesNotDependOnTheCornerOfTheDomain) {
    for (const Boundary boundary : {Boundary::torus, Boundary::box}) {
        std::vector<std::vector<Point>> sets{maximal_set(3)};
        for (Point& point : sets[0])  // so that moving it loses no digit
            point = {std::round(point.x * 65536) / 65536, std::round(point.y * 65536) / 65536};
        const Statistics expected = analyze(sets, {1, 1, boundary});
        for (Point& point : sets[0]) point = {point.x - 448000, point.y + 541100};
        EXPECT_THROW(analyze(sets, {1, 1, boundary}), BadRequest);
        const Statistics moved = analyze(sets, {1, 1, boundary, -448000, 541100});
        EXPECT_EQ(moved.least_distance, expected.least_distance);
        EXPECT_EQ(moved.mean_distance, expected.mean_distance);
        EXPECT_EQ(moved.pair_correlation, expected.pair_correlation);
        EXPECT_EQ(moved.psi_6, expected.psi_6);
        EXPECT_EQ(moved.effective_nyquist, expected.effective_nyquist);
        EXPECT_EQ(moved.rings.back().power, expected.rings.back().power);
    }
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
