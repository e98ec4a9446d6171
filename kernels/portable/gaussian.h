// Descent of the Gaussian energy (docs/design.md, section 9): the force between two samples, and
// how samples move.
//
// A unit is 2^-bits of the mean spacing of the samples. A squared distance in units becomes an
// entry of a table, GAUSSIAN_ENTRIES_A_UNIT of them a squared mean spacing, and the rest to the
// next entry in 1/65536. A weight is a whole number of 2^-24, a force a sum of weights times units,
// and a momentum a whole number of 2^-28 mean spacings.
//
// Nothing here overflows, because host/relax/gaussian.cpp keeps these limits:
//   bits      13 to 24
//   a side    less than 2^31 units, and at least 2^bits / 32
//   a weight  between 0 and 2^28; times a distance at most 2^(bits + 25)
//   crowds    at most 2^10 samples in a square of two mean spacings, so that the force on a sample
//             is less than 2^62, and an item's loops take less than 2^16 turns
#ifndef LACUNA_PORTABLE_GAUSSIAN_H
#define LACUNA_PORTABLE_GAUSSIAN_H
#include "types.h"

LACUNA_BEGIN

// Samples farther apart than this many mean spacings do not act on each other.
#define GAUSSIAN_REACH 5u
#define GAUSSIAN_ENTRY_BITS 10u
#define GAUSSIAN_ENTRIES_A_UNIT 1024u
#define GAUSSIAN_ENTRIES (GAUSSIAN_REACH * GAUSSIAN_REACH * GAUSSIAN_ENTRIES_A_UNIT)
#define GAUSSIAN_WEIGHT_BITS 24u
// The tables along an axis of a box, GAUSSIAN_ENTRIES_A_UNIT a mean spacing from its edge.
#define GAUSSIAN_EDGE_REACH 6u
#define GAUSSIAN_EDGE_ENTRIES (GAUSSIAN_EDGE_REACH * GAUSSIAN_ENTRIES_A_UNIT)

struct GaussianDomain {
    u32 width;  // units
    u32 height;
    u32 wraps;  // 1 if both axes wrap, otherwise 0
    u32 bits;
    u32 samples;
    u32 columns;  // of the grid of cells through which samples find their neighbours
    u32 rows;
    u32 row_reach;  // rows of cells, up and down, that may hold neighbours
};
LACUNA_TYPEDEF(GaussianDomain)

// The entry below a squared distance; GAUSSIAN_ENTRIES, whose weight is 0, beyond the reach.
LACUNA_FN u32 gaussian_entry(u64 squared, u32 bits) {
    u64 entry = squared >> (2u * bits - GAUSSIAN_ENTRY_BITS);
    return entry < GAUSSIAN_ENTRIES ? to_u32(entry) : GAUSSIAN_ENTRIES;
}

LACUNA_FN u32 gaussian_rest(u64 squared, u32 bits) {
    return to_u32(squared >> (2u * bits - GAUSSIAN_ENTRY_BITS - 16u)) & 0xffffu;
}

// The weight between two neighbouring entries.
LACUNA_FN i32 gaussian_weight(i32 low, i32 high, u32 rest) {
    i64 wide = rest;
    wide = wide * (high - low);
    return low + to_i32(to_u32(wide >> 16));
}

// How far from an edge of a box: the entry, and the value between it and the next one.
LACUNA_FN u32 gaussian_edge_entry(u32 distance, u32 bits) {
    u32 entry = distance >> (bits - GAUSSIAN_ENTRY_BITS);
    return entry < GAUSSIAN_EDGE_ENTRIES ? entry : GAUSSIAN_EDGE_ENTRIES;
}

LACUNA_FN i64 gaussian_edge_value(i32 low, i32 high, u32 distance, u32 bits) {
    u32 rest_bits = bits - GAUSSIAN_ENTRY_BITS;
    i64 wide = distance & ((1u << rest_bits) - 1u);
    return low + (wide * (high - low) >> rest_bits);
}

// The force of a box along an axis. `pull` is what the near edge's table has less what the far
// edge's has; `across` is the sum of both edges' tables of areas along the other axis.
LACUNA_FN i64 gaussian_edge_force(i64 pull, i64 across, u32 bits) {
    return pull * across >> (GAUSSIAN_WEIGHT_BITS - bits);
}

// The momentum that a force leaves: 922/1024 of the one before and the force itself, but at most 4
// mean spacings.
LACUNA_FN i32 gaussian_momentum(i32 before, i64 force, u32 bits) {
    i64 most = 1 << 30;
    i64 kept = before;
    i64 next = (kept * 922 >> 10) + (force >> (bits - 4u));
    next = next < most ? next : most;
    return to_i32(to_u32(next > -most ? next : -most));
}

// The coordinate after a step, of a side of `length` units. `pace` is the step's length in 1/65536
// of the momentum, at most a quarter, so no step is longer than a mean spacing. On a torus the
// coordinate wraps; on a box it stops at the edge.
LACUNA_FN u32 gaussian_place(u32 at, i32 momentum, u32 pace, u32 length, u32 wraps, u32 bits) {
    i64 wide = momentum;
    i64 quick = pace;
    i64 one = 1;
    u32 rest_bits = 44u - bits;
    i64 side = length;
    i64 from = at;
    i64 to = from + ((wide * quick + (one << (rest_bits - 1u))) >> rest_bits);
    if (wraps != 0u) return to_u32(to_u64(to + side * 64) % to_u64(side));
    return to < 0 ? 0u : to_u32(to < side ? to : side - 1);
}

// The cell of a coordinate, out of `cells` along a side of `length` units.
LACUNA_FN u32 gaussian_cell(u32 at, u32 cells, u32 length) {
    u64 wide = at;
    return to_u32(wide * cells / length);
}

LACUNA_END

#endif
