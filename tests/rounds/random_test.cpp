// Philox 4x32-10 against Random123's published vectors, and the scaling of its bits.
#include "rounds/random.h"
#include "rounds/random_run.h"

#include <gtest/gtest.h>

#include <array>

namespace {

using lacuna::random_bits;
using lacuna::scaled;

TEST(Random, PhiloxGivesItsPublishedVectors) {
    // kat_vectors of Random123: philox4x32, 10 rounds.
    struct Vector {
        std::array<std::uint32_t, 4> counter;
        std::array<std::uint32_t, 2> key;
        std::array<std::uint32_t, 4> result;
    };
    const Vector vectors[] = {
        {{0, 0, 0, 0}, {0, 0}, {0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}},
        {{0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff},
         {0xffffffff, 0xffffffff},
         {0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}},
        {{0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344},
         {0xa4093822, 0x299f31d0},
         {0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}},
    };
    for (const Vector& vector : vectors) {
        const r123::Philox4x32::ctr_type counter = {
            {vector.counter[0], vector.counter[1], vector.counter[2], vector.counter[3]}};
        const r123::Philox4x32::key_type key = {{vector.key[0], vector.key[1]}};
        const auto result = r123::Philox4x32{}(counter, key);
        for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(result[i], vector.result[i]);
    }
}

TEST(Random, DrawZeroOfSeedZeroIsTheFirstVector) {
    const lacuna::RandomBits bits = random_bits(0, 0);
    EXPECT_EQ(bits.first, 0xe169c58d6627e8d5u);
    EXPECT_EQ(bits.second, 0x9b00dbd8bc57ac4cu);
}

TEST(Random, EveryArgumentMatters) {
    const auto base = random_bits(1, 2, 3);
    EXPECT_NE(base.first, random_bits(2, 2, 3).first);
    EXPECT_NE(base.first, random_bits(1 + (std::uint64_t{1} << 32), 2, 3).first);
    EXPECT_NE(base.first, random_bits(1, 3, 3).first);
    EXPECT_NE(base.first, random_bits(1, 2 + (std::uint64_t{1} << 32), 3).first);
    EXPECT_NE(base.first, random_bits(1, 2, 4).first);
}

// Runs of every length, from any draw: also across the carry of a counter's lowest word.
TEST(Random, RunsAreTheBitsOfEachDraw) {
    for (const lacuna::RandomRun* const way : lacuna::all_random_runs()) {
        SCOPED_TRACE(way->name);
        for (const std::uint64_t first : {std::uint64_t{0}, std::uint64_t{12'345},
                                          (std::uint64_t{1} << 32) - 9, ~std::uint64_t{0} - 40})
            for (const std::size_t length : {0u, 1u, 7u, 8u, 9u, 33u}) {
                const std::uint64_t seed = 0x0123456789abcdefU + length;
                std::vector<lacuna::RandomBits> run(length);
                way->fill(seed, first, run);
                for (std::size_t i = 0; i < length; ++i) {
                    const lacuna::RandomBits expected = random_bits(seed, first + i);
                    ASSERT_EQ(run[i].first, expected.first) << first << " + " << i;
                    ASSERT_EQ(run[i].second, expected.second) << first << " + " << i;
                }
            }
    }
}

TEST(Random, ScaledCoversItsRangeAndNoMore) {
    constexpr std::uint64_t most = ~std::uint64_t{0};
    for (const std::uint64_t range : {std::uint64_t{1}, std::uint64_t{7}, most}) {
        EXPECT_EQ(scaled(0, range), 0u);
        EXPECT_EQ(scaled(most, range), range - 1);
    }
    EXPECT_EQ(scaled(most / 2 + 1, 10), 5u);
}

}  // namespace
