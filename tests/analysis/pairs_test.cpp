// Given any set, distances agree with a comparison of all pairs one by one.
#include "analysis/pairs.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include "analysis/sets.h"
#include "verify/closest.h"

namespace lacuna::analysis {
namespace {

std::vector<Domain> domains() {
    return {{1, 1, true}, {1, 1, false}, {4, 0.5, true}, {0.3, 2, false}};
}

// Half of the points crowd around one spot.
std::vector<Point> clustered(std::size_t count, const Domain& domain, std::uint64_t seed) {
    std::vector<Point> points = white_noise(count, domain, seed);
    for (std::size_t i = 0; i < count / 2; ++i)
        points[i] = {points[i].x / 50, domain.height - points[i].y / 50};
    return points;
}

double nearest_by_brute_force(const std::vector<Point>& points, const Domain& domain,
                              std::size_t index) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < points.size(); ++j)
        if (j != index) least = std::min(least, domain.distance(points[index], points[j]));
    return least;
}

TEST(NearestDistances, AreThoseOfAllPairs) {
    for (const Domain& domain : domains()) {
        for (const auto& points : {white_noise(300, domain, 1), clustered(300, domain, 2)}) {
            const Neighbours neighbours(points, domain);
            const std::vector<double> nearest = nearest_distances(neighbours);
            for (std::size_t i = 0; i < points.size(); ++i)
                EXPECT_NEAR(nearest[i], nearest_by_brute_force(points, domain, i),
                            1e-12 * domain.longer_side());
            EXPECT_NEAR(*std::min_element(nearest.begin(), nearest.end()),
                        verify::closest_pair(domain, points).distance,
                        1e-12 * domain.longer_side());
        }
    }
}

TEST(NearestDistances, OfPointsThatCoincideAreZero) {
    const std::vector<Point> points(40, Point{0.25, 0.5});
    for (const double distance : nearest_distances(Neighbours(points, {1, 1, true})))
        EXPECT_EQ(distance, 0);
}

RC_GTEST_PROP(SixNearest, AreTheFirstSixOfAllByDistance, ()) {
    // Few points, thin tori, equal coordinates: here images hide other points.
    const Domain domain{*rc::gen::inRange(1, 100) / 10.0, *rc::gen::inRange(1, 100) / 10.0,
                        *rc::gen::arbitrary<bool>()};
    const auto along = [](double side) {
        return rc::gen::map(rc::gen::inRange(0, 21), [side](int i) { return side * i / 20; });
    };
    const auto count = *rc::gen::inRange<std::size_t>(1, 30);
    std::vector<Point> points;
    for (std::size_t i = 0; i < count; ++i)
        points.push_back({*along(domain.width), *along(domain.height)});
    const Neighbours neighbours(points, domain);
    for (std::size_t i = 0; i < count; ++i) {
        std::vector<double> all;
        for (std::size_t j = 0; j < count; ++j)
            if (j != i) all.push_back(domain.distance(points[i], points[j]));
        std::sort(all.begin(), all.end());
        all.resize(std::min<std::size_t>(all.size(), 6));
        const auto nearest = neighbours.nearest(i, 6);
        RC_ASSERT(nearest.size() == all.size());
        for (std::size_t n = 0; n < all.size(); ++n) {
            RC_ASSERT(std::abs(nearest[n].distance - all[n]) < 1e-9);
            RC_ASSERT(std::abs(std::hypot(nearest[n].dx, nearest[n].dy) - all[n]) < 1e-9);
        }
    }
}

TEST(CountedPairs, AreThoseOfAllPairs) {
    for (const Domain& domain : domains()) {
        const std::vector<Point> points = clustered(400, domain, 3);
        constexpr std::size_t kBins = 25;
        const double width = std::min(domain.width, domain.height) / 2 / kBins;
        std::vector<std::uint64_t> expected(kBins, 0);
        for (std::size_t i = 0; i < points.size(); ++i)
            for (std::size_t j = i + 1; j < points.size(); ++j) {
                const double bin = domain.distance(points[i], points[j]) / width;
                if (bin < kBins) ++expected[static_cast<std::size_t>(bin)];
            }
        EXPECT_EQ(Neighbours(points, domain).count_pairs(width, kBins), expected);
    }
}

TEST(CountedPairs, OfPointsOnTheEdgesOfATorusAreThoseOfAllPairs) {
    for (const Domain& domain : domains()) {
        // Far fewer bins than cells, so that not all of the domain is within reach.
        std::vector<Point> points = white_noise(3000, domain, 5);
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (i % 3 == 0) points[i].x = i % 2 == 0 ? 0 : domain.width;
            if (i % 5 == 0) points[i].y = i % 4 == 0 ? 0 : domain.height;
        }
        constexpr std::size_t kBins = 7;
        const double width = std::min(domain.width, domain.height) / 9 / kBins;
        std::vector<std::uint64_t> expected(kBins, 0);
        for (std::size_t i = 0; i < points.size(); ++i)
            for (std::size_t j = i + 1; j < points.size(); ++j) {
                const double bin = domain.distance(points[i], points[j]) / width;
                if (bin < kBins) ++expected[static_cast<std::size_t>(bin)];
            }
        EXPECT_EQ(Neighbours(points, domain).count_pairs(width, kBins), expected);
    }
}

// A bin of n expected pairs scatters by sqrt(n); the tolerance is five times that.
TEST(PairCorrelation, OfWhiteNoiseIs1OnTorusAndBox) {
    for (const Domain& domain : domains()) {
        const std::vector<Point> points = white_noise(20000, domain, 4);
        const Neighbours neighbours(points, domain);
        constexpr std::size_t kBins = 40;  // 0.2 mean spacings
        const std::vector<double> g = coarser(pair_correlation(neighbours), kBins);
        ASSERT_GE(g.size(), 40U);
        for (std::size_t i = 0; i < g.size(); ++i) {
            const double middle = (static_cast<double>(i) + 0.5) * kBins * kPairBin;
            const double pairs = 10000 * 2 * std::numbers::pi * middle * kBins * kPairBin;
            EXPECT_NEAR(g[i], 1, 5 / std::sqrt(pairs)) << "at " << middle;
        }
    }
}

// The edge of a box matters here: without its correction g would be 0.6.
TEST(PairCorrelation, OfFewPointsInABoxIs1OnTheMeanOfManySets) {
    const Domain domain{2, 1, false};
    double sum = 0;
    constexpr int kSets = 4000;
    for (int seed = 0; seed < kSets; ++seed) {
        const std::vector<Point> points = white_noise(40, domain, static_cast<std::uint64_t>(seed));
        sum += pair_correlation_between(Neighbours(points, domain), 0.4, 0.5) / kSets;
    }
    // 780 pairs a set; a fraction of about 0.14 * 0.6 is expected here.
    EXPECT_NEAR(sum, 1, 5 / std::sqrt(kSets * 780 * 0.08));
}

TEST(PairCorrelation, OfALatticeIsNothingBetweenItsDistances) {
    const Domain domain{1, 1, true};
    constexpr int kSide = 40;
    const std::vector<Point> points = grid(kSide, kSide, domain);
    const Neighbours neighbours(points, domain);
    const std::vector<double> g = pair_correlation(neighbours);
    ASSERT_EQ(g.size(), 2000U);
    for (std::size_t i = 0; i < 190; ++i) EXPECT_EQ(g[i], 0) << i;
    EXPECT_GT(g[199] + g[200], 100);
    for (std::size_t i = 210; i < 270; ++i) EXPECT_EQ(g[i], 0) << i;
    // 2 pairs a point at 1 spacing, over the pairs expected from 0.9 to 1.1: 0.4 pi / 2.
    EXPECT_NEAR(pair_correlation_between(neighbours, 0.9 / kSide, 1.1 / kSide),
                4 / (0.4 * std::numbers::pi) * 1600 / 1599, 1e-9);
}

TEST(RelativeRadius, IsOneForAHexagonalLatticeAndLessForASquareOne) {
    const Domain domain = hexagonal_domain(10, 6);
    const std::vector<Point> points = hexagonal(10, 6);
    const std::vector<double> nearest = nearest_distances(Neighbours(points, domain));
    const double least = *std::min_element(nearest.begin(), nearest.end());
    EXPECT_NEAR(least, 1, 1e-12);
    EXPECT_NEAR(relative_radius(least, domain, points.size()), 1, 1e-12);
    EXPECT_NEAR(relative_radius(0.1, {1, 1, true}, 100), std::sqrt(std::sqrt(3.0) / 2), 1e-12);
}

}  // namespace
}  // namespace lacuna::analysis
