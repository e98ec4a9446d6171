// Given spectra and sets of known order, the numbers of order are right.
#include "analysis/order.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "analysis/pairs.h"
#include "analysis/sets.h"

namespace lacuna::analysis {
namespace order_test {

constexpr Domain kUnitTorus{1, 1, true};

Radial radial_of_points(const std::vector<Point>& points, const Domain& domain) {
    return radial_of(mean_spectrum(Sets{points}, domain, carry_on));
}

BondOrder bond_order_of(const std::vector<Point>& points, const Domain& domain) {
    return bond_order(Neighbours(points, domain)).value();
}

// Annuli of power(frequency), narrow enough to make a curve.
template <class Power>
Radial curve(const Power& power) {
    Radial radial;
    constexpr double kWidth = 0.002;
    for (std::size_t a = 0; a < 1000; ++a) {
        const double frequency = (static_cast<double>(a) + 0.5) * kWidth;
        radial.annuli.push_back(
            {frequency, frequency + kWidth / 2, power(frequency), 2 * a + 1, std::nullopt});
    }
    return radial;
}

// The disk's mean of a step at f0 is 1 - (f0 / f)^2: a tenth at f0 / sqrt(0.9). Step blue noise has
// f0 = sqrt(1 / pi), the highest possible (Heck, Schloemer & Deussen 2013).
TEST(EffectiveNyquist, OfStepBlueNoiseIsThatOfItsClosedForm) {
    const double step = std::sqrt(1 / std::numbers::pi);
    const Radial radial = curve([&](double f) { return f < step ? 0.0 : 1.0; });
    EXPECT_NEAR(effective_nyquist(radial).value(), step / std::sqrt(0.9), 0.003);
}

TEST(EffectiveNyquist, LooksForTheLastQuietDiskBeforeTheFirstLoudOne) {
    // Quiet up to 0.2, then a bump that is averaged out by 0.8, where the power begins.
    const Radial radial = curve([](double f) {
        return f > 0.2 && f < 0.25 ? 0.3 : f < 0.8 ? 0 : 2;
    });
    const double bump = 0.3 * (0.25 * 0.25 - 0.2 * 0.2);
    EXPECT_NEAR(effective_nyquist(radial).value(), std::sqrt((2 * 0.64 - bump) / 1.9), 0.003);
}

TEST(EffectiveNyquist, OfALatticeIs1AndOfWhiteNoise0) {
    const double lattice =
        effective_nyquist(radial_of_points(grid(64, 64, kUnitTorus), kUnitTorus)).value();
    EXPECT_NEAR(lattice, 1, 2.0 / 64);
    EXPECT_EQ(effective_nyquist(radial_of_points(white_noise(4096, kUnitTorus, 1), kUnitTorus)), 0);
}

TEST(EffectiveNyquist, OfASpectrumWithoutPowerIsNone) {
    EXPECT_FALSE(effective_nyquist(curve([](double) { return 0.0; })));
}

// Independent points: g = 1, P = 1.
TEST(PowerFromPairs, OfAFlatPairCorrelationIs1) {
    EXPECT_EQ(power_from_pairs(std::vector<double>(2000, 1.0), 0.7), 1);
}

// A bump of g - 1 at x = 1.5, far within the window's flat top, transforms to a Gaussian times J0:
// 2 pi 1.5 J0(2 pi f 1.5) sigma sqrt(2 pi) exp(-(2 pi f sigma)^2 / 2) for a narrow sigma.
TEST(PowerFromPairs, OfARingIsABesselFunction) {
    constexpr double kSigma = 0.02;
    constexpr double kRing = 1.5;
    std::vector<double> g(20000, 1.0);
    for (std::size_t i = 0; i < g.size(); ++i) {
        const double x = (static_cast<double>(i) + 0.5) * kPairBin;
        g[i] += std::exp(-std::pow((x - kRing) / kSigma, 2) / 2);
    }
    for (const double f : {0.0, 0.3, 0.9, 2.1}) {
        const double turn = 2 * std::numbers::pi * f;
        const double expected =
            1 + 2 * std::numbers::pi * kRing * std::cyl_bessel_j(0, turn * kRing) * kSigma *
                    std::sqrt(2 * std::numbers::pi) * std::exp(-std::pow(turn * kSigma, 2) / 2);
        EXPECT_NEAR(power_from_pairs(g, f), expected, 0.005) << f;
    }
}

TEST(PowerFromPairs, IsThePeriodogramsRadialPower) {
    const std::vector<Point> points = grid(80, 80, kUnitTorus, 1, 5);
    const Radial radial = radial_of_points(points, kUnitTorus);
    const std::vector<double> g = pair_correlation(Neighbours(points, kUnitTorus));
    // Means over wide rings: the periodogram's scatter by 1 / sqrt(modes).
    for (const double from : {0.2, 0.5, 0.8, 1.2, 1.6}) {
        double exact = 0;
        double modes = 0;
        double paired = 0;
        for (const Annulus& annulus : radial.annuli) {
            if (annulus.frequency < from || annulus.frequency > from + 0.3) continue;
            const auto weight = static_cast<double>(annulus.modes);
            exact += weight * annulus.power;
            paired += weight * power_from_pairs(g, annulus.frequency);
            modes += weight;
        }
        EXPECT_NEAR(paired / modes, exact / modes, 5 / std::sqrt(modes)) << from;
    }
}

// White noise oscillates only by the noise of its count; a lattice has nothing but oscillations.
TEST(Oscillations, TellKindsOfSetsApart) {
    const auto of = [](const std::vector<Point>& points) {
        return oscillations(pair_correlation(Neighbours(points, kUnitTorus))).value();
    };
    const double white = of(white_noise(6400, kUnitTorus, 2));
    const double jittered = of(grid(80, 80, kUnitTorus, 1, 3));
    const double nearly_lattice = of(grid(80, 80, kUnitTorus, 0.3, 4));
    EXPECT_LT(white, 0.3) << "jittered " << jittered;
    EXPECT_LT(jittered, 0.5) << "white " << white;
    EXPECT_GT(nearly_lattice, 2);
}

TEST(Oscillations, OfTooFewPointsAreNone) {
    const std::vector<Point> points = white_noise(9, kUnitTorus, 1);
    EXPECT_FALSE(oscillations(pair_correlation(Neighbours(points, kUnitTorus))));
}

TEST(BondOrder, OfAHexagonalLatticeIs1) {
    const BondOrder order = bond_order_of(hexagonal(12, 7), hexagonal_domain(12, 7));
    EXPECT_NEAR(order.global, 1, 1e-9);
    EXPECT_NEAR(order.local, 1, 1e-9);
    EXPECT_EQ(order.points, 168U);
}

TEST(BondOrder, OfLatticesTurnedApartIsHighForEachPointAndLowForAll) {
    // Two boxes of triangles, one turned by a twelfth: psi_6 of opposite signs.
    Domain domain{60, 60, false};
    std::vector<Point> points;
    for (int i = -60; i <= 60; ++i)
        for (int j = -60; j <= 60; ++j) {
            const double along = i + 0.5 * j;
            const double across = std::sqrt(3.0) / 2 * j;
            const Point first{15 + along, 30 + across};
            const Point second{45 + across, 30 + along};
            if (first.x > 0 && first.x < 30 && first.y > 0 && first.y < 60) points.push_back(first);
            if (second.x > 30 && second.x < 60 && second.y > 0 && second.y < 60)
                points.push_back(second);
        }
    const BondOrder order = bond_order_of(points, domain);
    EXPECT_GT(order.local, 0.9);
    EXPECT_LT(order.global, 0.1);
    EXPECT_LT(order.points, points.size());  // points at the box's edge do not count
}

// Without a common direction the mean of n unit vectors times 0.4 is under 5 * 0.4 / sqrt(n).
TEST(BondOrder, OfWhiteNoiseIsThatOfRandomDirections) {
    const BondOrder order = bond_order_of(white_noise(20000, kUnitTorus, 6), kUnitTorus);
    EXPECT_LT(order.global, 5 * 0.4 / std::sqrt(20000.0));
    EXPECT_NEAR(order.local, 0.37, 0.01);
}

TEST(BondOrder, OfSixPointsIsNone) {
    const std::vector<Point> points = white_noise(6, kUnitTorus, 1);
    EXPECT_FALSE(bond_order(Neighbours(points, kUnitTorus)));
}

}  // namespace order_test
}  // namespace lacuna::analysis
