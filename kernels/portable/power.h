// Relaxation on a lattice (docs/design.md, section 9): powers, centres of mass, and steps of
// weights.
//
// A unit is 1/256 of the lattice's shorter step. A sample has a position in units. Its weight here
// is even_weight(), half the squared diagonal, minus its own, in squared units. So weights are
// whole numbers of at least 0, and the sample with the least |p - s|^2 - w is the one with the
// least |p - s|^2 + weight.
//
// Nothing here overflows, because host/lattice/lattice.cpp keeps these limits:
//   lattice points                at most 2^31
//   lattice points of one side    at most 2^21; times all lattice points at most 2^46
//   a step                        256 to 511 units; so a side has less than 2^30 units, and the
//                                 squared diagonal, `farthest`, is less than 2^61
//   all masses together           less than 2^49; times the lattice points of one side less than
//                                 2^62
#ifndef LACUNA_PORTABLE_POWER_H
#define LACUNA_PORTABLE_POWER_H
#include "distance.h"

LACUNA_BEGIN

#define NO_OWNER 0xffffffffu

struct RelaxLattice {
    u64 farthest;     // over any squared distance; no weight is over it
    u64 mean_mass;    // mean mass of a sample
    u64 lonely_step;  // a quarter of a sample's mean area, and 1 more
    u32 columns;      // lattice points
    u32 rows;
    u32 step_x;  // units
    u32 step_y;
    u32 period_x;  // the width in units if it wraps, otherwise 0
    u32 period_y;
    u32 cut_x;  // lattice points in a pixel's width
    u32 cut_y;
    u32 pixel_columns;
    u32 pixel_rows;
    u32 samples;
    u32 padding;
};
LACUNA_TYPEDEF(RelaxLattice)

// The mass of a pixel's lattice points is stored as a significand of at most 21 bits and, from bit
// 24 on, an exponent of at most 31. The masses of a leaf are counted in units of 2^e, where e is
// the greatest exponent of its pixels with importance: rounded down, but at least 1 where there is
// any. So 32 bits hold the sums over a leaf.
#define MASS_BITS 21u
#define MASS_EXPONENT_AT 24u
LACUNA_FN u32 mass_in_leaf(u32 stored, u32 exponent) {
    u32 significand = stored % (1u << MASS_EXPONENT_AT);
    u32 mass = significand >> (exponent - (stored >> MASS_EXPONENT_AT));
    return mass == 0u && stored != 0u ? 1u : mass;
}

LACUNA_FN u64 whole_mass(u32 stored) {
    u64 significand = stored % (1u << MASS_EXPONENT_AT);
    return significand << (stored >> MASS_EXPONENT_AT);
}

// Whether a sample stays where it is: without mass it has nowhere to go. A sample with less mass
// than the lattice point below it has lost this point to one of many that crowd there; the lattice
// is too coarse for them, and what it has lies elsewhere.
LACUNA_FN bool stays(u64 mass, u32 stored) {
    return mass == 0u || mass < whole_mass(stored);
}

// The position of lattice point `index` on an axis, in units.
LACUNA_FN u32 lattice_place(u32 index, u32 step) {
    return index * step + step / 2u;
}

// The power of a position (px, py) for a sample: below 2^62.
LACUNA_FN u64 power_of(u32 px, u32 py, u32 sx, u32 sy, u64 weight, u32 period_x, u32 period_y) {
    return squared_length(axis_distance(px, sx, period_x), axis_distance(py, sy, period_y)) +
           weight;
}

// The steps from the lattice point below the sample at `at` to lattice point `index` of an axis,
// the shortest way, plus `count`, so that the result is not negative. It is at most 2 count, so the
// sum over all points, weighted by mass, is at most 2^62 * 2 = 2^63.
LACUNA_FN u32 moment_offset(u32 index, u32 at, u32 step, u32 count, u32 period) {
    u32 place = lattice_place(index, step);
    u32 straight = place > at ? place - at : at - place;
    bool wraps = period != 0u && period - straight < straight;
    u32 offset = index + count - at / step;
    if (!wraps) return offset;
    return place > at ? offset - count : offset + count;
}

// One coordinate of the centre of a mass of at least 1, rounded to the nearest unit. `moment` is
// the sum of mass times moment_offset. On a box the centre never lies outside its lattice points.
LACUNA_FN u32 centre_of_mass(u64 moment, u64 mass, u32 at, u32 step, u32 count, u32 period) {
    u64 wide = step;
    u64 length = wide * count;
    u64 whole = moment / mass + at / step;
    u64 rest = moment % mass;
    u64 units = whole * wide + step / 2u + (rest * wide + mass / 2u) / mass;
    return to_u32(period == 0u ? units - length : units % length);
}

// The change of a sample's weight relative to its area, in 1/65536: eta |mean - m| / (1.73 m), at
// most eta mean / (2 m), and at most MOST_GROWTH. With eta = 1/2 the constants are 37/128 and
// 32/128. Intermediate values are below 2^49 * 32 * 512 = 2^63.
#define MOST_GROWTH 262144u
LACUNA_FN u64 weight_growth(u64 mass, u64 mean_mass) {
    u64 off = mass > mean_mass ? mass - mean_mass : mean_mass - mass;
    u64 wanted = off * 37u;
    u64 most = mean_mass * 32u;
    u64 growth = (wanted < most ? wanted : most) * 512u / mass;
    u64 limit = MOST_GROWTH;
    return growth < limit ? growth : limit;
}

// The change in squared units for an area of `points` lattice points: below 2^31 * 2^18 * 2^10. One
// of the steps is 256 units.
LACUNA_FN u64 weight_step(u64 growth, u32 points, u32 step_x, u32 step_y) {
    u64 area = points;
    return growth * area * (step_x * step_y / 256u) / 256u;
}

// The weight here of a sample whose own weight is 0, as all have at first.
LACUNA_FN u64 even_weight(u64 farthest) {
    return farthest / 2u;
}

// The new weight of a sample with this mass and number of lattice points. The weight here of a
// sample without mass sinks, so that its cell grows. No sum here is over 2^62.
LACUNA_FN u64 moved_weight(RelaxLattice lattice, u64 weight, u64 mass, u32 points) {
    u64 step = lattice.lonely_step;
    if (mass != 0u)
        step = weight_step(weight_growth(mass, lattice.mean_mass), points, lattice.step_x,
                           lattice.step_y);
    // In signed numbers: with NVIDIA's Vulkan driver 580.159, a > b ? a - b : 0u of unsigned 64-bit
    // numbers is a - b where a is below b, too.
    i64 greatest = to_i64(even_weight(lattice.farthest) * 2u);
    i64 change = to_i64(step);
    i64 moved = to_i64(weight) + (mass < lattice.mean_mass ? -change : change);
    moved = moved < 0 ? 0 : moved;
    return to_u64(moved < greatest ? moved : greatest);
}

// The bounds of a sample's own weight, in sixteenths of the squared distance to the nearest other
// sample. Two own weights differ by less than the squared distance of their samples. So each sample
// lies inside its own cell, and none takes all mass of another.
#define MOST_WEIGHT 10u
#define LEAST_WEIGHT 5u

// A squared distance, at least 16. Samples at least so far away do not change this weight.
LACUNA_FN u64 reach_of_weight(u64 farthest, u64 weight) {
    u64 even = even_weight(farthest);
    u64 reach = weight < even ? (even - weight) / MOST_WEIGHT : (weight - even) / LEAST_WEIGHT;
    return reach * 16u + 16u;
}

// The weight here within its bounds, which are never 0: of two samples on one spot one must get a
// cell. `nearest` is the squared distance to the nearest other sample, or the reach if that is
// less: below 2^62. In signed numbers, as above.
LACUNA_FN u64 bounded_weight(u64 farthest, u64 weight, u64 nearest) {
    i64 even = to_i64(even_weight(farthest));
    i64 part = to_i64(nearest / 16u) + 1;
    i64 least = even - part * MOST_WEIGHT;
    i64 greatest = even + part * LEAST_WEIGHT;
    i64 bounded = to_i64(weight);
    bounded = bounded < least ? least : bounded;
    return to_u64(bounded < greatest ? bounded : greatest);
}

// How far a sample moves, in 256ths of its way to its centre of mass. A long way, 1.7 times the
// whole one, needs fewer iterations; the last iterations go the whole way.
#define WHOLE_WAY 256u
#define LONG_WAY 435u

// A coordinate after a move towards `centre`; the way is the shorter one where the axis wraps. On a
// box it stays below `length` units. The product is below 2^30 * 2^9.
LACUNA_FN u32 moved_place(u32 at, u32 centre, u32 way, u32 length, u32 period) {
    bool is_above = centre > at;
    u32 off = is_above ? centre - at : at - centre;
    if (period != 0u && period - off < off) {
        off = period - off;
        is_above = !is_above;
    }
    u64 wide = off;
    u32 step = to_u32(wide * way / 256u);
    u32 room = is_above ? length - 1u - at : at;
    if (step <= room) return is_above ? at + step : at - step;
    if (period == 0u) return is_above ? length - 1u : 0u;
    return is_above ? at + step - period : at + period - step;
}

LACUNA_END

#endif
