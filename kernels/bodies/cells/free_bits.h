// The free parts of a line in mode cells are words of bits, from `slot` on.
#include "portable/bits.h"

// A word as a piece: the height of its lowest bit, and its bits.
BODY u32x2 piece_at(MEMORY const u32 slot, const u32 number) {
    return U32X2(number * 32u, AT(bits, slot + number));
}

BODY u32 length_of(const u32x2 piece) {
    return count_bits(piece.y);
}

BODY u32 height_of_rank(const u32x2 piece, const u32 rank) {
    return piece.x + bit_of_rank(piece.y, rank);
}
