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
#include <utility>
#include <vector>

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

ThresholdMask frame_of(const ThresholdMask& mask, std::size_t frame) {
    const std::size_t pixels = std::size_t{mask.columns} * mask.rows;
    ThresholdMask one{mask.columns, mask.rows, 1, {}};
    one.ranks.assign(&mask.ranks[frame * pixels], &mask.ranks[frame * pixels] + pixels);
    return one;
}

TEST(FramesOfThresholdMasks, AreEachEvenAtEveryLevel) {
    constexpr std::uint32_t kFrames = 8, kPixels = 32 * 32;
    const ThresholdMask mask = threshold_mask(32, 32, 2, kFrames);
    EXPECT_EQ(mask.frames, kFrames);
    std::vector<std::uint32_t> ranks = mask.ranks;
    std::sort(ranks.begin(), ranks.end());
    for (std::uint32_t i = 0; i < kPixels * kFrames; ++i) ASSERT_EQ(ranks[i], i);
    for (std::uint32_t tenth = 1; tenth <= 9; ++tenth) {
        const std::uint32_t level = kPixels * kFrames * tenth / 10;
        double sum = 0;
        for (std::size_t frame = 0; frame < kFrames; ++frame) {
            const ThresholdMask one = frame_of(mask, frame);
            const auto under = std::count_if(one.ranks.begin(), one.ranks.end(),
                                             [&](std::uint32_t rank) { return rank < level; });
            EXPECT_NEAR(static_cast<double>(under), level / 8., 6) << tenth << ", " << frame;
            sum += low_power(one, level, 0.1) * level * (1 - level / 1024.) /
                   (static_cast<double>(under) * (1 - static_cast<double>(under) / 1024.));
        }
        EXPECT_LT(sum / kFrames, 0.04) << tenth;
    }
}

// The power of the values of each pixel over the frames, in that of white noise.
TEST(FramesOfThresholdMasks, HaveLittlePowerAtLowFrequenciesInTime) {
    constexpr std::size_t kFrames = 16, kPixels = 24 * 24;
    const ThresholdMask mask = threshold_mask(24, 24, 0, kFrames);
    for (const auto& [cycles, most] : {std::pair(1, 0.06), {2, 0.3}}) {
        double sum = 0;
        for (std::size_t pixel = 0; pixel < kPixels; ++pixel) {
            std::complex<double> amplitude = 0;
            for (std::size_t frame = 0; frame < kFrames; ++frame)
                amplitude += (mask.ranks[frame * kPixels + pixel] + 0.5) / (kFrames * kPixels) *
                             std::polar(1., 2 * std::numbers::pi * cycles *
                                                static_cast<double>(frame) / kFrames);
            sum += std::norm(amplitude) * 12 / kFrames;
        }
        EXPECT_LT(sum / kPixels, most) << cycles;
    }
}

// Two frames are each other's neighbours in time, half of the period away.
TEST(FramesOfThresholdMasks, AreUnlikeTheNextOneAlsoIfTheyAreTwo) {
    constexpr std::size_t kPixels = 16 * 16;
    for (const std::uint32_t frames : {2U, 3U, 4U}) {
        const ThresholdMask mask = threshold_mask(16, 16, 0, frames);
        const auto deviation = [&](std::size_t i) {
            return mask.ranks[i] - (static_cast<double>(kPixels * frames) - 1) / 2;
        };
        double product = 0, square = 0;
        for (std::size_t i = 0; i < kPixels; ++i) {
            product += deviation(i) * deviation(kPixels + i);
            square += deviation(i) * deviation(i);
        }
        EXPECT_LT(product / square, -0.1) << frames;
    }
}

// The mean over many pairs of tiles, as they are and with the second one moved.
TEST(AThresholdMask, IsNotCorrelatedWithThoseOfOtherSeeds) {
    constexpr std::uint32_t kSide = 32, kPixels = kSide * kSide;
    constexpr std::size_t kTiles = 60;
    std::vector<std::vector<double>> tiles;
    for (std::uint64_t seed = 0; seed < kTiles; ++seed) {
        std::vector<double>& tile = tiles.emplace_back();
        for (const std::uint32_t rank : threshold_mask(kSide, kSide, seed).ranks)
            tile.push_back((rank + 0.5) / kPixels - 0.5);
    }
    for (const std::size_t moved : {0U, kSide * 5 + 11}) {
        double sum = 0;
        for (std::size_t a = 0; a < kTiles; ++a)
            for (std::size_t b = 0; b < a; ++b)
                for (std::size_t i = 0; i < kPixels; ++i)
                    sum += tiles[a][i] * tiles[b][(i + moved) % kPixels];
        EXPECT_NEAR(sum * 12 / kPixels / (kTiles * (kTiles - 1) / 2.), 0, 0.005) << moved;
    }
}

}  // namespace
}  // namespace lacuna
