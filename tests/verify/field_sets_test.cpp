// Given many radii, the closest pair is that of all pairs, and crowds and large fields take no
// time. Sets on fields, and those that the proof's gaps have filled, are judged by hostile.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cstdio>
#include <tuple>
#include <vector>

#include "fields.h"
#include "judge/judge.h"
#include "verify/closest.h"
#include "verify/on_field.h"

namespace lacuna::verify {
namespace field_sets_test {

Pair closest_of_all(const lacuna::Domain& domain, std::span<const Disk> disks) {
    Pair closest;
    for (std::size_t i = 0; i < disks.size(); ++i)
        for (std::size_t j = i + 1; j < disks.size(); ++j) {
            Pair pair{i, j, judge::distance(domain, disks[i].at, disks[j].at),
                      std::min(disks[i].radius, disks[j].radius)};
            pair.ratio = pair.distance / pair.limit;
            if (pair.ratio < closest.ratio) closest = pair;
        }
    return closest;
}

TEST(AFewPointsOnAFieldOfAMillionPixels, LeaveALargestGapThatIsFoundWithoutAnEnd) {
    judge::Random random(7);
    const OnField made{tests::sizes_field(1000, 1000, 7), 1e-6, {1, 1, Boundary::torus}};
    std::vector<Point> points;
    for (int i = 0; i < 100; ++i) points.push_back(judge::any_place(random, made.domain));
    const Proof proof = prove(points, made.claim());
    EXPECT_FALSE(proof.covered);
    const double found = proof.largest_gap_distance - proof.largest_gap_limit;
    Request request{.domain = made.domain};
    request.field = &made.field;
    const judge::Judge judge(request, points, {}, made.scale);
    EXPECT_NEAR(judge.room(proof.largest_gap), found, 1e-9);
    EXPECT_LE(judge.largest_gap_of_raster(300).room, found * (1 + 1e-6));
}

// Samples with coordinates on a grid of `grid` steps, and radii over a range of 10^6.
std::vector<Disk> draw_disks(const lacuna::Domain& domain, int grid) {
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
    const lacuna::Domain domain{width, width * *rc::gen::element(1.0, 0.3, 7.0),
                                *rc::gen::element(Boundary::box, Boundary::torus)};
    const std::vector<Disk> disks = draw_disks(domain, *rc::gen::element(5, 1000, 1 << 30));
    const Pair found = closest_pair(domain_of(domain), disks);
    const Pair expected = closest_of_all(domain, disks);
    RC_ASSERT(found.ratio == expected.ratio);
    if (expected.ratio == 0) return;
    RC_ASSERT(found.first == expected.first);
    RC_ASSERT(found.second == expected.second);
}

// With pairs below kHopeless: the closest of all pairs in the shortest walk, from the largest
// radius to the smallest, that has such a pair.
RC_GTEST_PROP(TheClosestPairOfManyRadii, IsTheFirstHopelessOneOfAWalk, ()) {
    const lacuna::Domain domain{1, 1, *rc::gen::element(Boundary::box, Boundary::torus)};
    std::vector<Disk> disks = draw_disks(domain, *rc::gen::element(5, 20));
    std::stable_sort(disks.begin(), disks.end(),
                     [](const Disk& a, const Disk& b) { return a.radius > b.radius; });
    Pair expected;
    for (std::size_t i = 0; i <= disks.size() && expected.ratio >= kHopeless; ++i)
        expected = closest_of_all(domain, std::span(disks).first(i));
    const Pair found = closest_pair(domain_of(domain), disks, {}, kHopeless);
    RC_ASSERT(found.ratio == expected.ratio);
    RC_ASSERT(found.first == expected.first);
    RC_ASSERT(found.second == expected.second);
}

// This would take hours if all pairs, or all points for every cell, were looked at.
TEST(ACrowdOfManyRadii, IsSeenThroughQuickly) {
    judge::Random random(3);
    for (const double size : {1e-9, 0.01}) {
        const OnField made{tests::sizes_field(64, 64, 3), 1e-6, {1, 1, Boundary::torus}};
        std::vector<Point> points(20000);
        for (Point& point : points)
            point = {0.5 + judge::any_in(random, -size, size),
                     0.5 + judge::any_in(random, -size, size)};
        const Proof proof = prove(points, made.claim());
        EXPECT_FALSE(proof.kept || proof.covered);
        EXPECT_GT(proof.largest_gap_distance, 0.69);
    }
}

}  // namespace field_sets_test
}  // namespace lacuna::verify
