// Given sets of known kinds, the radial numbers tell them apart.
#include "analysis/radial.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "analysis/sets.h"

namespace lacuna::analysis {
namespace radial_test {

constexpr Domain kUnitTorus{1, 1, true};

struct Measured {
    Spectrum spectrum;
    Radial radial;
};

Measured measured(const Sets& sets, const Domain& domain = kUnitTorus) {
    Measured result{mean_spectrum(sets, domain, carry_on), {}};
    result.radial = radial_of(result.spectrum);
    return result;
}

// `make(seed)` ten times.
template <class Make>
Sets ten_sets(const Make& make) {
    Sets sets;
    for (std::uint64_t seed = 0; seed < 10; ++seed) sets.push_back(make(seed));
    return sets;
}

Sets ten_of_white_noise(const Domain& domain) {
    return ten_sets([&](std::uint64_t seed) { return white_noise(1000, domain, seed); });
}

// Rows of the box are filled unevenly, columns evenly: a bias along y alone.
std::vector<Point> with_uneven_rows(std::uint64_t seed) {
    Random random(seed);
    constexpr int kRows = 32;
    std::vector<double> ends;
    double end = 0;
    for (int row = 0; row < kRows; ++row) ends.push_back(end -= std::log(1 - uniform(random)));
    std::vector<Point> points(1024);
    for (Point& point : points) {
        const double chosen = end * uniform(random);
        std::size_t row = 0;
        while (ends[row] < chosen) ++row;
        point = {uniform(random), (static_cast<double>(row) + uniform(random)) / kRows};
    }
    return points;
}

// The standard error of a line's mean power.
double error_of(const LinePower& line, std::size_t sets) {
    return 1 / std::sqrt(static_cast<double>(line.modes * sets));
}

// Five standard errors of the mean of n powers, each the mean of `sets` exponential variables.
void expect_flat(const Radial& radial, double sets) {
    for (const Annulus& annulus : radial.annuli)
        EXPECT_NEAR(annulus.power, 1, 5 / std::sqrt(static_cast<double>(annulus.modes) * sets))
            << "at " << annulus.frequency;
}

TEST(Annuli, HoldEveryFrequencyOfTheDiskOnceAndAreTwoWide) {
    const auto [spectrum, radial] = measured({white_noise(500, kUnitTorus, 1)});
    std::vector<std::size_t> modes(radial.annuli.size(), 0);
    std::vector<double> sums(radial.annuli.size(), 0);
    for (int kx = -60; kx <= 60; ++kx) {
        for (int ky = -60; ky <= 60; ++ky) {
            const double length = std::sqrt(kx * kx + ky * ky);
            const auto annulus = static_cast<std::size_t>(length / 2);
            if (annulus >= modes.size() || (kx == 0 && ky == 0)) continue;
            ++modes[annulus];
            sums[annulus] += spectrum.power(kx, ky);
        }
    }
    EXPECT_GE(2.0 * static_cast<double>(modes.size()), 2 * std::sqrt(500.0));
    for (std::size_t a = 0; a < modes.size(); ++a) {
        EXPECT_EQ(2 * radial.annuli[a].modes, modes[a]);
        EXPECT_NEAR(radial.annuli[a].power, sums[a] / static_cast<double>(modes[a]), 1e-12);
        EXPECT_NEAR(radial.annuli[a].outer * std::sqrt(500.0), 2.0 * (static_cast<double>(a) + 1),
                    1e-12);
    }
    EXPECT_EQ(&radial.at(0), &radial.annuli.front());
    EXPECT_EQ(&radial.at(7.0 / std::sqrt(500.0)), &radial.annuli[3]);
    EXPECT_EQ(&radial.at(100), &radial.annuli.back());
}

// Mean anisotropy: some 6,300 powers, each the mean of ten exponential variables, whose variance
// is known to a relative sqrt(2.6 / 6300), 0.09 dB. The logarithm takes 0.03 dB off.
TEST(WhiteNoise, OfTenSetsIsFlatAt1AndAtMinus10Decibels) {
    for (const Domain& domain : {kUnitTorus, Domain{10, 0.1, true}, Domain{2, 3, false}}) {
        const auto [spectrum, radial] = measured(ten_of_white_noise(domain), domain);
        expect_flat(radial, 10);
        EXPECT_NEAR(radial.mean_anisotropy_db().value(), -10, 0.4);
        const auto vertical = vertical_line(spectrum, radial);
        EXPECT_NEAR(vertical->ratio, 1, 5 * error_of(*vertical, 10));
        const auto horizontal = horizontal_line(spectrum, radial);
        EXPECT_NEAR(horizontal->ratio, 1, 5 * error_of(*horizontal, 10));
    }
}

// One set: the variance of an exponential is known to a relative sqrt(8 / 6300), 0.15 dB.
TEST(WhiteNoise, OfOneSetIsFlatAt1AndAtZeroDecibels) {
    const auto [spectrum, radial] = measured({white_noise(1000, kUnitTorus, 77)});
    expect_flat(radial, 1);
    EXPECT_NEAR(radial.mean_anisotropy_db().value(), 0, 0.8);
}

// P = 1 - (sinc(kx / n) sinc(ky / n))^2 off the peaks: each point is jittered on its own.
TEST(JitteredGrid, HasTheRadialPowerOfItsClosedFormAndNoPeaksOfALattice) {
    constexpr int kSide = 32;
    const auto [spectrum, radial] = measured(
        ten_sets([](std::uint64_t seed) { return grid(kSide, kSide, kUnitTorus, 1, seed); }));
    const auto sinc = [](int k) {
        const double angle = std::numbers::pi * k / kSide;
        return k == 0 ? 1 : std::sin(angle) / angle;
    };
    std::vector<double> expected(radial.annuli.size(), 0);
    for (int kx = -70; kx <= 70; ++kx)
        for (int ky = -70; ky <= 70; ++ky) {
            const auto annulus = static_cast<std::size_t>(std::sqrt(kx * kx + ky * ky) / 2);
            if (annulus >= expected.size() || (kx == 0 && ky == 0)) continue;
            expected[annulus] += (1 - std::pow(sinc(kx) * sinc(ky), 2)) /
                                 (2 * static_cast<double>(radial.annuli[annulus].modes));
        }
    for (std::size_t a = 0; a < expected.size(); ++a)
        EXPECT_NEAR(radial.annuli[a].power, expected[a],
                    5 * expected[a] / std::sqrt(10.0 * static_cast<double>(radial.annuli[a].modes)))
            << "at " << radial.annuli[a].frequency;
    EXPECT_LT(radial.at(0.1).power, 0.05);
    EXPECT_LT(radial.peak().power, 1.2);
}

TEST(RegularLattice, HasAllItsPowerInPeaksAndNoAnisotropyWhereThereIsNone) {
    constexpr int kSide = 32;
    const auto [spectrum, radial] = measured({grid(kSide, kSide, kUnitTorus)});
    const Annulus& peak = radial.peak();
    // Half the plane has two of the four peaks at k = 32.
    EXPECT_NEAR(peak.power, 2.0 * kSide * kSide / static_cast<double>(peak.modes), 1e-9);
    EXPECT_NEAR(peak.frequency, 1, 0.05);
    EXPECT_GT(peak.anisotropy_db.value(), 10);
    EXPECT_LT(radial.at(0.5).power, 1e-9);
    EXPECT_FALSE(radial.at(0.5).anisotropy_db);
}

TEST(VerticalBias, ShowsOnTheVerticalLineAloneAndNotInWhiteNoise) {
    const auto [spectrum, radial] = measured(ten_sets(with_uneven_rows));
    const auto vertical = vertical_line(spectrum, radial);
    const auto horizontal = horizontal_line(spectrum, radial);
    EXPECT_GT(vertical->ratio, 1 + 20 * error_of(*vertical, 10));
    EXPECT_NEAR(horizontal->ratio, 1, 5 * error_of(*horizontal, 10));

    // Turned by a quarter, the bias is on the other line.
    Sets turned = ten_sets(with_uneven_rows);
    for (auto& points : turned)
        for (Point& point : points) std::swap(point.x, point.y);
    const auto [turned_spectrum, turned_radial] = measured(turned);
    EXPECT_NEAR(horizontal_line(turned_spectrum, turned_radial)->ratio, vertical->ratio, 1e-9);
    EXPECT_NEAR(vertical_line(turned_spectrum, turned_radial)->ratio, horizontal->ratio, 1e-9);
}

}  // namespace radial_test
}  // namespace lacuna::analysis
