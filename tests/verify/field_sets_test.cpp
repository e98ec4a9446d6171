// Given hostile fields, sets are filled until the proof finds no gap. A slow look at a raster then
// confirms that they are maximal, and they are refuted with a point less or a point too many.
#include "verify/field_sets.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cstdio>
#include <tuple>
#include <vector>

#include "verify/closest.h"
#include "verify/largest_gap.h"

namespace lacuna::verify {
namespace field_sets_test {

constexpr std::uint64_t kFirstSeed = 18000;
constexpr std::uint64_t kCases = 90;
constexpr std::size_t kMost = 2000;

// Throws some darts, and then adds the largest gap that the proof finds, until it finds none.
std::vector<Point> filled(const FieldCase& made, std::mt19937_64& random) {
    std::vector<Point> points;
    for (int dart = 0; dart < 200; ++dart) {
        const Point at = any_place(random, made.domain);
        const auto over = made.over(points, at);
        if (over && *over >= made.tolerance()) points.push_back(at);
    }
    while (points.size() < kMost) {
        const Proof proof = prove(points, made.claim());
        if (proof.covered) return points;
        EXPECT_GT(proof.largest_gap_distance, proof.largest_gap_limit);
        points.push_back(proof.largest_gap);
        // The far edges do not belong to a torus.
        if (made.domain.torus && points.back().x >= made.domain.width) points.back().x = 0;
        if (made.domain.torus && points.back().y >= made.domain.height) points.back().y = 0;
    }
    ADD_FAILURE() << "no end of points";
    return points;
}

Pair closest_of_all(const Domain& domain, std::span<const Disk> disks) {
    Pair closest;
    for (std::size_t i = 0; i < disks.size(); ++i)
        for (std::size_t j = i + 1; j < disks.size(); ++j) {
            Pair pair{i, j, domain.distance(disks[i].at, disks[j].at),
                      std::min(disks[i].radius, disks[j].radius)};
            pair.ratio = pair.distance / pair.limit;
            if (pair.ratio < closest.ratio) closest = pair;
        }
    return closest;
}

// A point that is too near to another point.
Point too_near(const FieldCase& made, std::span<const Point> points, std::mt19937_64& random) {
    for (;;) {
        const Point at = any_place(random, made.domain);
        const auto over = made.over(points, at);
        if (over && *over < 0) return at;
    }
}

void expect_refuted_with_a_point_less(const FieldCase& made, std::vector<Point> points,
                                      std::size_t index) {
    const Point gone = points[index];
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(index));
    const Proof less = prove(points, made.claim());
    EXPECT_TRUE(less.kept);
    EXPECT_FALSE(less.covered);
    EXPECT_TRUE(made.is_open(less.largest_gap));
    if (points.empty()) return;
    const double found = less.largest_gap_distance - less.largest_gap_limit;
    EXPECT_GT(found, made.tolerance());
    EXPECT_LE(made.most_over_of_raster(points, 60), found * (1 + 1e-6) + made.tolerance());
    const auto spot_radius = made.most_radius_near(less.largest_gap);
    const auto gone_radius = made.most_radius_near(gone);
    ASSERT_TRUE(spot_radius && gone_radius);
    EXPECT_LT(made.domain.distance(less.largest_gap, gone), std::min(*spot_radius, *gone_radius));
}

void check_filled(const FieldCase& made, std::uint64_t seed, std::size_t& all_points) {
    std::mt19937_64 random(seed + 1);
    SCOPED_TRACE("seed " + std::to_string(seed) + ": " + made.name);
    std::vector<Point> points = filled(made, random);
    all_points += points.size();
    const Proof proof = prove(points, made.claim());
    EXPECT_TRUE(proof.kept && proof.covered && proof.maximal);
    EXPECT_LE(made.most_over_of_raster(points, 60), made.tolerance());
    if (points.empty()) return;

    std::vector<Point> crowded = points;
    crowded.push_back(too_near(made, points, random));
    const Proof refuted = prove(crowded, made.claim());
    EXPECT_FALSE(refuted.kept);
    EXPECT_EQ(refuted.second, points.size());
    EXPECT_LT(refuted.least_distance, refuted.least_limit);

    expect_refuted_with_a_point_less(made, points, random() % points.size());
}

// Checks the cases that make_case makes from seeds. On average they have more than `least_points`
// points.
template <typename MakeCase>
void check_many_filled(MakeCase make_case, std::size_t least_points) {
    std::printf("seeds %lu to %lu\n", kFirstSeed, kFirstSeed + kCases - 1);
    std::size_t points = 0;
    for (std::uint64_t seed = kFirstSeed; seed < kFirstSeed + kCases; ++seed)
        check_filled(make_case(seed), seed, points);
    std::printf("%lu sets, %zu points\n", kCases, points);
    EXPECT_GT(points, least_points * kCases);
}

TEST(ASetFilledAlongAField, IsMaximalAndRefutedWithAPointLessOrTooMany) {
    check_many_filled(hostile_case, 5);
}

TEST(ASetFilledWhereSamplesMayLie, IsMaximalAndRefutedWithAPointLessOrTooMany) {
    check_many_filled(closed_case, 3);
}

TEST(AFewPointsOnAFieldOfAMillionPixels, LeaveALargestGapThatIsFoundWithoutAnEnd) {
    std::mt19937_64 random(7);
    FieldCase made{"large noise", noise(random, 1000, 1000, 1e6), 1e-6, {1, 1, true}};
    std::vector<Point> points;
    for (int i = 0; i < 100; ++i) points.push_back(any_place(random, made.domain));
    const Proof proof = prove(points, made.claim());
    EXPECT_FALSE(proof.covered);
    const double found = proof.largest_gap_distance - proof.largest_gap_limit;
    EXPECT_NEAR(made.over(points, proof.largest_gap).value(), found, 1e-12);
    EXPECT_LE(made.most_over_of_raster(points, 300), found * (1 + 1e-6));
}

// Samples with coordinates on a grid of `grid` steps, and radii over a range of 10^6.
std::vector<Disk> draw_disks(const Domain& domain, int grid) {
    const auto drawn = *rc::gen::container<std::vector<std::tuple<int, int, int>>>(rc::gen::tuple(
        rc::gen::inRange(0, grid), rc::gen::inRange(0, grid), rc::gen::inRange(0, 24)));
    std::vector<Disk> disks;
    for (const auto& [i, j, size] : drawn)
        disks.push_back({{domain.width * i / grid, domain.height * j / grid},
                         domain.longer_side() * std::pow(10, -size / 4)});
    return disks;
}

RC_GTEST_PROP(TheClosestPairOfManyRadii, IsThatOfAllPairs, ()) {
    const double width = *rc::gen::element(1.0, 2.5, 0.01, 1e30);
    const Domain domain{width, width * *rc::gen::element(1.0, 0.3, 7.0),
                        *rc::gen::arbitrary<bool>()};
    const std::vector<Disk> disks = draw_disks(domain, *rc::gen::element(5, 1000, 1 << 30));
    const Pair found = closest_pair(domain, disks);
    const Pair expected = closest_of_all(domain, disks);
    RC_ASSERT(found.ratio == expected.ratio);
    if (expected.ratio == 0) return;
    RC_ASSERT(found.first == expected.first);
    RC_ASSERT(found.second == expected.second);
}

// With pairs below kHopeless: the closest of all pairs in the shortest walk, from the largest
// radius to the smallest, that has such a pair.
RC_GTEST_PROP(TheClosestPairOfManyRadii, IsTheFirstHopelessOneOfAWalk, ()) {
    const Domain domain{1, 1, *rc::gen::arbitrary<bool>()};
    std::vector<Disk> disks = draw_disks(domain, *rc::gen::element(5, 20));
    std::stable_sort(disks.begin(), disks.end(),
                     [](const Disk& a, const Disk& b) { return a.radius > b.radius; });
    Pair expected;
    for (std::size_t i = 0; i <= disks.size() && expected.ratio >= kHopeless; ++i)
        expected = closest_of_all(domain, std::span(disks).first(i));
    const Pair found = closest_pair(domain, disks, {}, kHopeless);
    RC_ASSERT(found.ratio == expected.ratio);
    RC_ASSERT(found.first == expected.first);
    RC_ASSERT(found.second == expected.second);
}

// This would take hours if all pairs, or all points for every cell, were looked at.
TEST(ACrowdOfManyRadii, IsSeenThroughQuickly) {
    std::mt19937_64 random(3);
    for (const double size : {1e-9, 0.01}) {
        FieldCase made{"noise", noise(random, 64, 64, 1e6), 1e-6, {1, 1, true}};
        std::vector<Point> points(20000);
        for (Point& point : points)
            point = {0.5 + any_in(random, -size, size), 0.5 + any_in(random, -size, size)};
        const Proof proof = prove(points, made.claim());
        EXPECT_FALSE(proof.kept || proof.covered);
        EXPECT_GT(proof.largest_gap_distance, 0.69);
    }
}

}  // namespace field_sets_test
}  // namespace lacuna::verify
