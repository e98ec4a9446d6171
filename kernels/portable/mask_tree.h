// A tree over the pixels of a mask (host/plan/mask_tree.h), as the cpu and kernels read it.
//
// A node is for a square of the mask, which it cuts into 4 x 4 slots. Its first word has the value
// of each slot, ALLOWED_NONE, ALLOWED_SOME or ALLOWED_ALL, in two bits. Slots are numbered by
// quadrant, and within a quadrant row by row. The nodes of the slots that have ALLOWED_SOME follow
// each other in the order of the slots; the second word is the index of the first of them.
#ifndef LACUNA_PORTABLE_MASK_TREE_H
#define LACUNA_PORTABLE_MASK_TREE_H
#include "radius_field.h"

// Words of a node.
#define NODE_WORDS 2u

LACUNA_BEGIN

// The slot of a pixel in a node whose slots are 2^shift pixels wide.
LACUNA_FN u32 slot_of(u32 column, u32 row, u32 shift) {
    u32 x = column >> shift & 3u;
    u32 y = row >> shift & 3u;
    return (y & 2u) << 2 | (x & 2u) << 1 | (y & 1u) << 1 | (x & 1u);
}

LACUNA_FN u32 value_of_slot(u32 values, u32 slot) {
    return values >> slot * 2u & 3u;
}

// The merged value of the quadrant that a slot lies in.
LACUNA_FN u32 value_of_quadrant(u32 values, u32 slot) {
    u32 four = values >> (slot & 12u) * 2u & 255u;
    if (four == ALLOWED_NONE * 85u) return ALLOWED_NONE;
    return four == ALLOWED_ALL * 85u ? ALLOWED_ALL : ALLOWED_SOME;
}

// The number of slots before this one that have ALLOWED_SOME, which is 1.
LACUNA_FN u32 rank_of_slot(u32 values, u32 slot) {
    u32 some = values & ~(values >> 1) & 0x55555555u;
    return count_bits(some & ((1u << slot * 2u) - 1u));
}

LACUNA_END

#endif
