// Given random sets, the proof agrees with looking at every pair and at a fine raster of spots.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "judge/judge.h"
#include "verify/closest.h"
#include "verify/largest_gap.h"
#include "verify/sets.h"

namespace lacuna::verify {
namespace {

// Points on a grid of `grid` steps. Only a coarse grid makes ties.
std::vector<Point> draw_points(const lacuna::Domain& domain, int grid) {
    const auto coordinates = rc::gen::pair(rc::gen::inRange(0, grid), rc::gen::inRange(0, grid));
    const auto cells = *rc::gen::container<std::vector<std::pair<int, int>>>(coordinates);
    std::vector<Point> points;
    for (const auto& [i, j] : cells)
        points.push_back({domain.width * i / grid, domain.height * j / grid});
    return points;
}

lacuna::Domain draw_domain() {
    const double width = *rc::gen::element(1.0, 2.5, 0.01, 1e30);
    return {width, width * *rc::gen::element(1.0, 0.3, 7.0),
            *rc::gen::element(Boundary::box, Boundary::torus)};
}

// The largest distance to the nearest point over a raster of (steps + 1)^2 spots. It is at most the
// size of the largest gap, and smaller by at most half a diagonal of the raster's squares.
double farthest_of_raster(const lacuna::Domain& domain, std::span<const Point> points, int steps) {
    return judge::Judge({.domain = domain}, points, {}, 0).largest_gap_of_raster(steps).room;
}

RC_GTEST_PROP(TheClosestPair, IsThatOfAllPairs, ()) {
    const lacuna::Domain domain = draw_domain();
    const std::vector<Point> points = draw_points(domain, *rc::gen::element(5, 1000, 1 << 30));
    const Pair found = closest_pair(domain_of(domain), points);
    const judge::Pair expected = judge::closest_pair(domain, points);
    RC_ASSERT(found.distance == expected.distance);
    if (points.size() < 2) return;
    RC_ASSERT(found.first < found.second);
    RC_ASSERT(judge::distance(domain, points[found.first], points[found.second]) == found.distance);
    if (found.distance == 0) return;
    RC_ASSERT(found.first == expected.first);
    RC_ASSERT(found.second == expected.second);
}

RC_GTEST_PROP(TheLargestGap, IsNoNearerThanAnyOfARasterAndAsFarAsItSays, ()) {
    constexpr int kSteps = 40;
    const lacuna::Domain domain = draw_domain();
    std::vector<Point> points = draw_points(domain, *rc::gen::element(5, 1000, 1 << 30));
    points.push_back({0, 0});
    const double limit = *rc::gen::element(0.05, 0.3, 1.0) * domain.longer_side();
    const Gap spot = largest_gap(domain_of(domain), points, limit);

    RC_ASSERT(spot.distance == judge::distance_to_nearest(domain, points, spot.at));
    const double raster = farthest_of_raster(domain, points, kSteps);
    RC_ASSERT(raster <= spot.distance * (1 + kGapPrecision) + kFinest * domain.longer_side());
    const double half_diagonal = std::hypot(domain.width, domain.height) / kSteps / 2;
    RC_ASSERT(spot.distance <= raster + half_diagonal * (1 + 1e-9));
}

std::vector<Point> random_points(std::size_t count, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> side(0, 1);
    std::vector<Point> points(count);
    for (Point& point : points) point = {side(random), side(random)};
    return points;
}

TEST(ALargeSet, HasTheClosestPairOfAllPairsAndNoSpotOfARasterIsFarther) {
    const std::vector<Point> points = random_points(4000, 1);
    for (const bool torus : {false, true}) {
        const lacuna::Domain domain{1, 1, torus ? Boundary::torus : Boundary::box};
        const judge::Pair expected = judge::closest_pair(domain, points);
        const Proof proof = check(points, 1, 1, torus, 0.01, 0);
        EXPECT_EQ(proof.least_distance, expected.distance);
        EXPECT_EQ(proof.first, expected.first);
        EXPECT_EQ(proof.second, expected.second);
        const double raster = farthest_of_raster(domain, points, 300);
        EXPECT_GE(proof.largest_gap_distance, raster * (1 - kGapPrecision));
        EXPECT_LE(proof.largest_gap_distance, raster + std::sqrt(0.5) / 300);
    }
}

TEST(AVerdict, IsTheSameInEveryRunWhateverTheThreads) {
    const std::vector<Point> points = random_points(20000, 2);
    const Proof first = check(points, 1, 1, true, 0.01, 0);
    for (int i = 0; i < 5; ++i) {
        const Proof again = check(points, 1, 1, true, 0.01, 0);
        EXPECT_EQ(again.largest_gap, first.largest_gap);
        EXPECT_EQ(again.largest_gap_distance, first.largest_gap_distance);
        EXPECT_EQ(again.first, first.first);
    }
}

// This would take hours if all pairs, or all points for every cell, were looked at.
TEST(ACrowd, OfPointsThatCoincideOrNearlySoIsSeenThroughQuickly) {
    std::vector<Point> points = random_points(100000, 3);
    for (Point& point : points) point = {0.5 + 1e-9 * point.x, 0.5 + 1e-9 * point.y};
    const Proof near = check(points, 1, 1, false, 0.1, 0);
    EXPECT_NEAR(near.largest_gap_distance, std::sqrt(0.5), 2e-9);
    EXPECT_FALSE(near.kept);

    std::fill(points.begin(), points.end(), Point{0.5, 0.5});
    const Proof same = check(points, 1, 1, true, 0.1, 0);
    EXPECT_NEAR(same.largest_gap_distance, std::sqrt(0.5), 1e-11);
    EXPECT_EQ(same.least_distance, 0);
    EXPECT_NE(same.first, same.second);
}

}  // namespace
}  // namespace lacuna::verify
