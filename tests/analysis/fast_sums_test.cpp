// Given any points, fast sums equal exact sums to within 1e-9 of each power, or of 1, the mean
// power of independent points. An analysis needs a thousand times less.
#include "analysis/fast_sums.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "analysis/maximal.h"
#include "analysis/sets.h"

namespace lacuna::analysis {
namespace {

constexpr Domain kUnitTorus{1, 1, true};
constexpr double kAllowed = 1e-9;

void expect_exact_powers(const std::vector<double>& powers, const std::vector<double>& exact) {
    ASSERT_EQ(powers.size(), exact.size());
    for (std::size_t i = 0; i < powers.size(); ++i)
        ASSERT_NEAR(powers[i], exact[i], kAllowed * std::max(1.0, exact[i])) << "entry " << i;
}

void expect_exact(const std::vector<Point>& points, const Domain& domain, Range range) {
    expect_exact_powers(fast_periodogram(points, domain, range, carry_on),
                        exact_periodogram(points, domain, range, carry_on));
}

void expect_exact(const std::vector<Point>& points, const Domain& domain) {
    expect_exact(points, domain, range_for(domain, static_cast<double>(points.size())));
}

TEST(FastSums, OfRandomPointsAreExactInDomainsOfAnyShape) {
    for (const Domain& domain : {kUnitTorus, Domain{1, 1, false}, Domain{0.7, 3.1, true},
                                 Domain{300, 0.2, false}, Domain{1e-3, 40, true}})
        for (const std::size_t count : {1U, 2U, 100U, 2500U})
            expect_exact(white_noise(count, domain, count), domain);
}

TEST(FastSums, OfMaximalSetsAreExactWhereThereIsHardlyAnyPower) {
    expect_exact(maximal_set(0.012, 1), kUnitTorus);
}

TEST(FastSums, OfLatticesAreExactBesideTheirPeaks) {
    const Domain domain{2, 1, true};
    expect_exact(grid(80, 40, domain), domain);
    const Spectrum spectrum = mean_spectrum(Sets{grid(80, 40, domain)}, domain, carry_on);
    EXPECT_NEAR(spectrum.power(80, 40), 3200, 1e-6);
    EXPECT_LT(spectrum.power(79, 40), spectrum.rounding());
    EXPECT_LT(spectrum.power(0, 1), spectrum.rounding());
    expect_exact(grid(80, 40, domain, 0.05, 1), domain);
    expect_exact(hexagonal(50, 29), hexagonal_domain(50, 29));
}

TEST(FastSums, OfPointsAtTheEdgesAreExact) {
    for (const Domain& domain : {kUnitTorus, Domain{5, 0.3, false}}) {
        std::vector<Point> points = white_noise(900, domain, 3);
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (i % 3 == 0) points[i].x = i % 2 == 0 ? 0 : domain.width;
            if (i % 5 == 0) points[i].y = i % 4 == 0 ? 0 : domain.height;
        }
        expect_exact(points, domain);
    }
}

TEST(FastSums, OfPointsInOnePlaceAreExact) {
    expect_exact(std::vector<Point>(2000, Point{0.999, 0.001}), kUnitTorus);
    std::vector<Point> crowded = white_noise(2000, kUnitTorus, 4);
    for (Point& point : crowded) point = {point.x / 1000, 1 - point.y / 1000};
    expect_exact(crowded, kUnitTorus);
}

TEST(FastSums, AreExactAtFewAndAtManyFrequencies) {
    const std::vector<Point> points = white_noise(1500, kUnitTorus, 5);
    for (const Range range :
         {Range{1, 1}, Range{7, 8}, Range{1, 200}, Range{150, 3}, Range{31, 33}})
        expect_exact(points, kUnitTorus, range);
}

TEST(FastSums, OfSeveralSetsAreAveragedWithExactOnes) {
    const Sets sets{white_noise(kManyPoints - 100, kUnitTorus, 6),
                    white_noise(kManyPoints + 100, kUnitTorus, 7), maximal_set(0.02, 8)};
    const Spectrum mean = mean_spectrum(sets, kUnitTorus, carry_on);
    std::vector<double> exact(mean.powers.size());
    for (const auto& points : sets) {
        const auto powers = exact_periodogram(points, kUnitTorus, mean.range, carry_on);
        for (std::size_t i = 0; i < exact.size(); ++i) exact[i] += powers[i] / 3;
    }
    expect_exact_powers(mean.powers, exact);
}

TEST(FastSums, TellHowFarTheyAreAndEndWhenToldAtAnyTime) {
    const std::vector<Point> points = white_noise(3000, kUnitTorus, 9);
    const Range range = range_for(kUnitTorus, 3000);
    std::vector<double> shares;
    fast_periodogram(points, kUnitTorus, range, [&](double share) {
        shares.push_back(share);
        return true;
    });
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_EQ(shares.back(), 1);
    for (const std::size_t last : {std::size_t{0}, std::size_t{1}, shares.size() - 1}) {
        std::size_t calls = 0;
        EXPECT_THROW(
            fast_periodogram(points, kUnitTorus, range, [&](double) { return calls++ < last; }),
            Cancelled);
        EXPECT_EQ(calls, last + 1);
    }
}

}  // namespace
}  // namespace lacuna::analysis
