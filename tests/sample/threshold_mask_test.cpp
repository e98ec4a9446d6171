// Tiles of thresholds: each rank once, and even patterns at every level, also across the edges.
#include <lacuna/threshold_mask.h>

#include <gtest/gtest.h>
#include <lacuna/errors.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "refusal.h"

namespace lacuna {
namespace {

// The mean power of the pixels of rank under `level`, at frequencies of up to `most` cycles a pixel
// on the torus. White noise has 1.
double low_power(const ThresholdMask& mask, std::uint32_t level, double most) {
    const double columns = mask.columns, rows = mask.rows, pixels = columns * rows;
    std::vector<std::size_t> pattern;
    for (std::size_t i = 0; i < mask.ranks.size(); ++i)
        if (mask.ranks[i] < level) pattern.push_back(i);
    double sum = 0;
    int count = 0;
    for (double y = -std::floor(most * rows); y <= most * rows; ++y)
        for (double x = 0; x <= most * columns; ++x) {
            if (std::hypot(x / columns, y / rows) > most || (x == 0 && y <= 0)) continue;
            std::complex<double> amplitude = 0;
            for (const std::size_t i : pattern)
                amplitude +=
                    std::polar(1., 2 * std::numbers::pi *
                                       (x * static_cast<double>(i % mask.columns) / columns +
                                        y * static_cast<double>(i / mask.columns) / rows));
            sum += std::norm(amplitude) / (level * (1 - level / pixels));
            ++count;
        }
    return sum / count;
}

TEST(AThresholdMask, HasEachRankOnce) {
    for (const auto& [columns, rows] : {std::pair{64U, 64U}, {8U, 8U}, {48U, 20U}}) {
        const ThresholdMask mask = threshold_mask(columns, rows);
        EXPECT_EQ(mask.columns, columns);
        std::vector<std::uint32_t> ranks = mask.ranks;
        std::sort(ranks.begin(), ranks.end());
        for (std::uint32_t i = 0; i < columns * rows; ++i) ASSERT_EQ(ranks[i], i);
    }
}

// Void and cluster with a deviation of 1.5, as examples/python/dithering_tile.py has it, has .022,
// .033, .023, .016, .017, .019, .024, .033 and .053.
TEST(AThresholdMask, HasLittlePowerAtLowFrequenciesAtEveryLevel) {
    for (const std::uint64_t seed : {0U, 7U}) {
        const ThresholdMask mask = threshold_mask(64, 64, seed);
        double sum = 0;
        for (int tenth = 1; tenth <= 9; ++tenth) {
            const double power =
                low_power(mask, static_cast<std::uint32_t>(4096 * tenth / 10), 0.1);
            EXPECT_LT(power, tenth == 1 || tenth == 9 ? 0.027 : 0.02) << tenth;
            sum += power;
        }
        EXPECT_LT(sum / 9, 0.017);
    }
}

TEST(AThresholdMask, IsTheSameForASeedAndAnotherForAnother) {
    EXPECT_EQ(threshold_mask(32, 32, 3).ranks, threshold_mask(32, 32, 3).ranks);
    EXPECT_NE(threshold_mask(32, 32, 3).ranks, threshold_mask(32, 32, 4).ranks);
}

TEST(AThresholdMask, HasSidesOf8To1024Pixels) {
    EXPECT_EQ(tests::refusal_of([] { threshold_mask(7, 64); }),
              "size 7x64: each side must be 8 to 1024 pixels");
    EXPECT_EQ(tests::refusal_of([] { threshold_mask(64, 1025); }),
              "size 64x1025: each side must be 8 to 1024 pixels");
}

}  // namespace
}  // namespace lacuna
