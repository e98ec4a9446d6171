// Relaxation on a lattice (docs/design.md, section 9): powers, centres of mass, and steps of the
// weights.
//
// A unit is 1/256 of the lattice's shorter step. A sample has a place in units and a weight: how
// much its weight is below the greatest of all weights, in squared units. So weights are whole
// numbers of at least 0, and the sample with the least |p - s|^2 - w is the one with the least |p -
// s|^2 + weight.
//
// Nothing here overflows, given what host/relax/lattice.cpp sees to:
//   lattice points                at most 2^31
//   lattice points of one side    at most 2^21, and so many times all lattice points 2^46
//   a step                        256 to 511 units; so a side has less than 2^30 units, and the
//                                 squared diagonal, `farthest`, is less than 2^61
//   the mass of a lattice point   less than 2^16; so all masses together are less than 2^47
#ifndef LACUNA_PORTABLE_POWER_H
#define LACUNA_PORTABLE_POWER_H
#include "distance.h"

LACUNA_BEGIN

#define NO_OWNER 0xffffffffu

struct RelaxLattice {
    u64 farthest;   // a weight of so much and a sample owns nothing: no two places are so far apart
    u64 mean_mass;  // of a sample
    u64 lonely_step;  // by which the weight of a sample grows that has no mass
    u32 columns;      // lattice points
    u32 rows;
    u32 step_x;  // units
    u32 step_y;
    u32 period_x;  // the width in units where it wraps, or 0
    u32 period_y;
    u32 cut_x;  // lattice points in a pixel's width
    u32 cut_y;
    u32 pixel_columns;
    u32 pixel_rows;
    u32 samples;
    u32 padding;
};
LACUNA_TYPEDEF(RelaxLattice)

// Where lattice point `index` of an axis lies, in units.
LACUNA_FN u32 lattice_place(u32 index, u32 step) {
    return index * step + step / 2u;
}

// Of a place (px, py) to a sample: below 2^62.
LACUNA_FN u64 power_of(u32 px, u32 py, u32 sx, u32 sy, u64 weight, u32 period_x, u32 period_y) {
    return squared_length(axis_distance(px, sx, period_x), axis_distance(py, sy, period_y)) +
           weight;
}

// How many steps lattice point `index` of an axis lies from the one below the sample at `at`, the
// shortest way, plus `count`, so as not to be negative. At most 2 count: the sum of all, each times
// its mass, is at most 2^16 * 2^46 * 2 = 2^63.
LACUNA_FN u32 moment_offset(u32 index, u32 at, u32 step, u32 count, u32 period) {
    u32 place = lattice_place(index, step);
    u32 straight = place > at ? place - at : at - place;
    bool wraps = period != 0u && period - straight < straight;
    u32 offset = index + count - at / step;
    if (!wraps) return offset;
    return place > at ? offset - count : offset + count;
}

// One coordinate of the centre of a mass of at least 1, rounded to the nearest unit; `moment` is
// the sum of masses times moment_offset. It lies where its lattice points do: on a box never
// outside of them.
LACUNA_FN u32 centre_of_mass(u64 moment, u64 mass, u32 at, u32 step, u32 count, u32 period) {
    u64 wide = step;
    u64 length = wide * count;
    u64 whole = moment / mass + at / step;
    u64 rest = moment % mass;
    u64 units = whole * wide + step / 2u + (rest * wide + mass / 2u) / mass;
    return to_u32(period == 0u ? units - length : units % length);
}

// By how much of its area a sample's weight changes, in 1/65536: eta |mean - m| / (1.73 m), at most
// eta mean / (2 m), where eta = 1/2 makes 37/128 and 32/128 of the constants, and never over
// MOST_GROWTH. Below 2^47 * 37 * 512 < 2^62 in between.
#define MOST_GROWTH 262144u
LACUNA_FN u64 weight_growth(u64 mass, u64 mean_mass) {
    u64 off = mass > mean_mass ? mass - mean_mass : mean_mass - mass;
    u64 wanted = off * 37u;
    u64 most = mean_mass * 32u;
    u64 growth = (wanted < most ? wanted : most) * 512u / mass;
    u64 limit = MOST_GROWTH;
    return growth < limit ? growth : limit;
}

// The same in squared units, for an area of so many lattice points: below 2^31 * 2^18 * 2^10. One
// of the steps is 256 units.
LACUNA_FN u64 weight_step(u64 growth, u32 points, u32 step_x, u32 step_y) {
    u64 area = points;
    return growth * area * (step_x * step_y / 256u) / 256u;
}

// What becomes of the weight of a sample that owns so many lattice points and so much mass, before
// the least of all is taken off: all are `farthest` too high, so as not to be negative. At most 3
// farthest, which is below 2^63.
LACUNA_FN u64 moved_weight(RelaxLattice lattice, u64 weight, u64 mass, u32 points) {
    u64 step = lattice.lonely_step;
    if (mass != 0u)
        step = weight_step(weight_growth(mass, lattice.mean_mass), points, lattice.step_x,
                           lattice.step_y);
    u64 bounded = step < lattice.farthest ? step : lattice.farthest;
    u64 middle = weight + lattice.farthest;
    return mass < lattice.mean_mass ? middle - bounded : middle + bounded;
}

// The weight when the least of all moved ones is 0.
LACUNA_FN u64 weight_above_least(u64 moved, u64 least, u64 farthest) {
    u64 weight = moved - least;
    return weight < farthest ? weight : farthest;
}

LACUNA_END

#endif
