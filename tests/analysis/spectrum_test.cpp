// Given point sets whose sums have a closed form, or few points summed one by one, the periodogram
// agrees with these.
#include "analysis/spectrum.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <vector>

#include "analysis/fast_sums.h"
#include "analysis/sets.h"

namespace lacuna::analysis {
namespace spectrum_test {

constexpr Domain kUnitTorus{1, 1, true};

Spectrum spectrum_of(const std::vector<Point>& points, const Domain& domain = kUnitTorus) {
    return mean_spectrum(Sets{points}, domain, carry_on);
}

// In long double, point by point.
double naive_power(const std::vector<Point>& points, const Domain& domain, int kx, int ky) {
    std::complex<long double> sum = 0;
    for (const Point& p : points) {
        const long double turns = kx * (static_cast<long double>(p.x) / domain.width) +
                                  ky * (static_cast<long double>(p.y) / domain.height);
        sum += std::polar(1.0L, -2 * std::numbers::pi_v<long double> * turns);
    }
    return static_cast<double>(std::norm(sum) / static_cast<long double>(points.size()));
}

void expect_naive_powers(const std::vector<double>& powers, Range range,
                         const std::vector<Point>& points, const Domain& domain, int step) {
    std::size_t at = 0;
    for (int kx = 0; kx <= range.kx_max; ++kx) {
        for (int ky = -range.ky_max; ky <= range.ky_max; ++ky, ++at) {
            if ((kx == 0 && ky == 0) || (kx + 3 * ky) % step != 0) continue;
            const double naive = naive_power(points, domain, kx, ky);
            ASSERT_NEAR(powers[at], naive, 1e-9 * std::max(1.0, naive)) << kx << " " << ky;
        }
    }
    EXPECT_EQ(at, powers.size());
}

// Calls `check(kx, ky)` for the whole plane except DC.
template <class Check>
void for_each_frequency(Range range, const Check& check) {
    for (int kx = -range.kx_max; kx <= range.kx_max; ++kx)
        for (int ky = -range.ky_max; ky <= range.ky_max; ++ky)
            if (kx != 0 || ky != 0) check(kx, ky);
}

TEST(Spectrum, OfOnePointIs1AtEveryFrequency) {
    const Spectrum spectrum = spectrum_of({{0.3, 0.7}});
    EXPECT_EQ(spectrum.range.kx_max, 5);
    for_each_frequency(spectrum.range, [&](int kx, int ky) {
        EXPECT_NEAR(spectrum.power(kx, ky), 1, 1e-12) << kx << " " << ky;
    });
}

TEST(Spectrum, OfTwoPointsIsOnePlusTheCosineOfTheirDifference) {
    const Domain domain{3, 0.5, false};
    const Spectrum spectrum = spectrum_of({{0.5, 0.125}, {2.25, 0.4}}, domain);
    for_each_frequency(spectrum.range, [&](int kx, int ky) {
        const double turns = kx * 1.75 / 3 + ky * 0.275 / 0.5;
        EXPECT_NEAR(spectrum.power(kx, ky), 1 + std::cos(2 * std::numbers::pi * turns), 1e-12)
            << kx << " " << ky;
    });
}

TEST(Spectrum, OfALatticeIsTheCountAtReciprocalPointsAndZeroElsewhere) {
    const Domain domain{2, 1, true};
    constexpr int kColumns = 14;
    constexpr int kRows = 9;
    const Spectrum spectrum = spectrum_of(grid(kColumns, kRows, domain), domain);
    int peaks = 0;
    for_each_frequency(spectrum.range, [&](int kx, int ky) {
        const bool is_peak = kx % kColumns == 0 && ky % kRows == 0;
        if (is_peak) ++peaks;
        EXPECT_NEAR(spectrum.power(kx, ky), is_peak ? kColumns * kRows : 0, 1e-9)
            << kx << " " << ky;
        EXPECT_EQ(spectrum.power(kx, ky) > spectrum.rounding(), is_peak);
    });
    EXPECT_GE(peaks, 8);
}

TEST(Spectrum, LeavesDcOut) {
    EXPECT_EQ(spectrum_of(white_noise(100, kUnitTorus, 1)).power(0, 0), 0);
}

TEST(Spectrum, OfRandomPointsIsThatOfSumsPointByPoint) {
    // More than two blocks of points, and a frequency range of several tasks.
    const Domain domain{0.7, 3.1, true};
    const std::vector<Point> points = white_noise(1100, domain, 2);
    const Range range = range_for(domain, 1100);
    expect_naive_powers(exact_periodogram(points, domain, range, carry_on), range, points, domain,
                        7);
    const Spectrum spectrum = spectrum_of(points, domain);
    expect_naive_powers(spectrum.powers, spectrum.range, points, domain, 7);
    EXPECT_EQ(spectrum.power(-5, 8), spectrum.power(5, -8));
    EXPECT_EQ(spectrum.power(0, -8), spectrum.power(0, 8));
}

TEST(Spectrum, IsExactAtTheFrequenciesOfAHundredThousandPoints) {
    // Recurrences lose digits with k: 2 sqrt(100,000) = 633.
    constexpr Range kFar{640, 640};
    const std::vector<Point> points = white_noise(5, kUnitTorus, 3);
    for (const auto& powers : {exact_periodogram(points, kUnitTorus, kFar, carry_on),
                               fast_periodogram(points, kUnitTorus, kFar, carry_on)})
        expect_naive_powers(powers, kFar, points, kUnitTorus, 41);
}

TEST(Spectrum, CoversTwiceTheSquareRootOfTheCountWhateverTheDomain) {
    for (const Domain& domain : {Domain{1, 1, true}, Domain{10, 0.5, true}, Domain{3, 7, false}}) {
        const Spectrum spectrum = spectrum_of(white_noise(400, domain, 4), domain);
        EXPECT_GE(spectrum.magnitude(spectrum.range.kx_max + 1, 0), 42);
        EXPECT_GE(spectrum.magnitude(0, spectrum.range.ky_max + 1), 42);
        // As many frequencies lie below |k| as in the unit square.
        int inside = 0;
        for_each_frequency(spectrum.range, [&](int kx, int ky) {
            if (spectrum.magnitude(kx, ky) < 40) ++inside;
        });
        EXPECT_NEAR(inside, std::numbers::pi * 1600, 160);
    }
}

TEST(Spectrum, OfSeveralSetsIsTheMeanOfTheirs) {
    const Sets sets{white_noise(90, kUnitTorus, 5), white_noise(110, kUnitTorus, 6)};
    const Spectrum mean = mean_spectrum(sets, kUnitTorus, carry_on);
    EXPECT_EQ(mean.sets, 2U);
    EXPECT_EQ(mean.count, 100);
    for_each_frequency(mean.range, [&](int kx, int ky) {
        const double expected =
            (naive_power(sets[0], kUnitTorus, kx, ky) + naive_power(sets[1], kUnitTorus, kx, ky)) /
            2;
        EXPECT_NEAR(mean.power(kx, ky), expected, 1e-9 * std::max(1.0, expected));
    });
}

TEST(Spectrum, IsTheSameOnAnyNumberOfThreads) {
    const std::vector<Point> points = white_noise(3000, kUnitTorus, 7);
    const Range range = range_for(kUnitTorus, 3000);
    for (const auto& made : {exact_periodogram, fast_periodogram}) {
        const std::vector<double> many = made(points, kUnitTorus, range, carry_on);
        const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
        EXPECT_EQ(made(points, kUnitTorus, range, carry_on), many);
    }
}

TEST(Spectrum, TellsHowFarItIsAndStopsWhenTold) {
    // One by fast sums, one by matrix products.
    const Sets sets{white_noise(2000, kUnitTorus, 8), white_noise(kManyPoints - 1, kUnitTorus, 9)};
    std::vector<double> shares;
    mean_spectrum(sets, kUnitTorus, [&](double share) {
        shares.push_back(share);
        return true;
    });
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_GE(shares.size(), 6U);
    EXPECT_NEAR(shares.back(), 1, 1e-12);

    int calls = 0;
    EXPECT_THROW(mean_spectrum(sets, kUnitTorus, [&](double) { return ++calls < 2; }), Cancelled);
    EXPECT_EQ(calls, 2);
}

}  // namespace spectrum_test
}  // namespace lacuna::analysis
