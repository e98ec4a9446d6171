// The bits of a lattice line in 32-bit words: bit y % 32 of word y / 32 stands for height y.
#ifndef LACUNA_PORTABLE_BITS_H
#define LACUNA_PORTABLE_BITS_H
#include "types.h"

LACUNA_BEGIN

// The bits of word `word` for heights in [begin, end). The interval must touch the word.
LACUNA_FN u32 word_mask(u32 word, u32 begin, u32 end) {
    u32 low = word * 32u;
    u32 below = begin > low ? begin - low : 0u;
    u32 above = end - low < 32u ? 32u - (end - low) : 0u;
    return (0xffffffffu << below) & (0xffffffffu >> above);
}

// The number of words for `rows` bits.
LACUNA_FN u32 words_of_column(u32 rows) {
    return (rows + 31u) / 32u;
}

// The lowest set bit of a word that is not 0. GLSL searches 32 bits at a time.
LACUNA_FN u32 lowest_bit(u32 word) {
    return count_bits(~word & (word - 1u));
}

LACUNA_FN u32 lowest_bit_of_64(u64 word) {
    u32 low = to_u32(word);
    return low != 0u ? lowest_bit(low) : 32u + lowest_bit(to_u32(word >> 32));
}

// The set bit of this rank, where the lowest set bit has rank 0. The word must have one.
LACUNA_FN u32 bit_of_rank(u32 word, u32 rank) {
    u32 rest = word;
    for (u32 i = 0u; i < rank; ++i) rest = rest & (rest - 1u);
    return lowest_bit(rest);
}

LACUNA_END

#endif
