// Words of bits against loops over their bits.
#include "portable/bits.h"

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace lacuna::portable;

TEST(WordMask, HasTheBitsOfTheHeightsInside) {
    for (u32 begin = 0; begin < 100; ++begin) {
        for (u32 end = begin + 1; end <= 130; ++end) {
            for (u32 word = begin / 32; word <= (end - 1) / 32; ++word) {
                u32 expected = 0;
                for (u32 bit = 0; bit < 32; ++bit)
                    if (32 * word + bit >= begin && 32 * word + bit < end) expected |= 1u << bit;
                ASSERT_EQ(word_mask(word, begin, end), expected)
                    << "[" << begin << ", " << end << "), word " << word;
            }
        }
    }
}

TEST(WordMask, HoldsForTheHighestLattice) {
    const u32 height = 1u << 17;
    EXPECT_EQ(word_mask(height / 32 - 1, 0, height), ~0u);
    EXPECT_EQ(word_mask(height / 32 - 1, height - 1, height), 1u << 31);
}

TEST(BitOfRank, CountsSetBitsFromTheLowest) {
    const std::uint64_t seed = 7;
    std::mt19937_64 random(seed);
    for (int i = 0; i < 100'000; ++i) {
        // Words of every density, including the full word and single bits.
        u32 word = to_u32(random());
        if (i % 3 == 0) word &= to_u32(random()) & to_u32(random());
        if (i % 3 == 1) word |= to_u32(random()) | to_u32(random());
        if (i < 32) word = 1u << i;
        if (i == 32) word = ~0u;
        u32 rank = 0;
        for (u32 bit = 0; bit < 32; ++bit) {
            if ((word >> bit & 1) == 0) continue;
            ASSERT_EQ(bit_of_rank(word, rank), bit) << word << ", seed " << seed;
            ++rank;
        }
        ASSERT_EQ(count_bits(word), rank) << word << ", seed " << seed;
    }
}

}  // namespace
