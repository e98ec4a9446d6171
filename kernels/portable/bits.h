// Bits of a lattice line in words of 32: bit y % 32 of word y / 32 stands for height y.
#ifndef LACUNA_PORTABLE_BITS_H
#define LACUNA_PORTABLE_BITS_H
#include "prelude.h"

LACUNA_BEGIN

// The bits of word `word` that stand for heights of [begin, end), which touches it.
LACUNA_FN u32 word_mask(u32 word, u32 begin, u32 end) {
    u32 low = word * 32u;
    u32 below = begin > low ? begin - low : 0u;
    u32 above = end - low < 32u ? 32u - (end - low) : 0u;
    return (0xffffffffu << below) & (0xffffffffu >> above);
}

// The lowest set bit of a word that has one. GLSL finds bits in 32 at a time.
LACUNA_FN u32 lowest_bit(u32 word) {
    return count_bits(~word & (word - 1u));
}

LACUNA_FN u32 lowest_bit_of_64(u64 word) {
    u32 low = to_u32(word);
    return low != 0u ? lowest_bit(low) : 32u + lowest_bit(to_u32(word >> 32));
}

// The rank-th set bit of a word that has more, the lowest being the 0th.
LACUNA_FN u32 bit_of_rank(u32 word, u32 rank) {
    u32 rest = word;
    for (u32 i = 0u; i < rank; ++i) rest = rest & (rest - 1u);
    return lowest_bit(rest);
}

LACUNA_END

#endif
