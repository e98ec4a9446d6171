// Which distance two samples of different radii must keep (section 4.2.1), on the lattice of mode
// cells. Radii are in units of 1/256 of a lattice step.
#ifndef LACUNA_PORTABLE_METRIC_H
#define LACUNA_PORTABLE_METRIC_H
#include "prelude.h"

#define METRIC_MIN 0u
#define METRIC_MEAN 1u
#define METRIC_MAX 2u

LACUNA_BEGIN

// The radius of two radii, doubled so that the mean is whole.
LACUNA_FN u32 twice_metric_radius(u32 metric, u32 a, u32 b) {
    if (metric == METRIC_MEAN) return a + b;
    bool is_a = metric == METRIC_MIN ? a < b : a > b;
    return 2u * (is_a ? a : b);
}

// Radii are sorted by classes, four to an octave, for which the lower bits count as one.
LACUNA_FN u32 low_bits_of_class(u32 radius) {
    return radius < 8u ? 0u : 29u - leading_zeros(radius);
}

#define RADIUS_CLASSES 124u
LACUNA_FN u32 radius_class(u32 radius) {
    u32 low_bits = low_bits_of_class(radius);
    return low_bits * 4u + (radius >> low_bits);
}

// The largest radius of a radius' class.
LACUNA_FN u32 class_bound(u32 radius) {
    return radius | ((1u << low_bits_of_class(radius)) - 1u);
}

// Lattice points conflict when their squared distance in steps is below this. `twice` is at
// least 1.
LACUNA_FN u64 metric_squared(u32 twice) {
    u64 wide = twice;
    return ((wide * wide - 1u) >> 18u) + 1u;
}

// With mean and max a sample may block places up to `reach` lattice steps away, farther than its
// `radius`, but only places whose own radius is wide. Where the reach is over four times the
// radius, it is worth while to look on each line for the widest radius that is still free
// (RadiusMap::widest_rows), and to go no farther than that asks for.
LACUNA_FN bool is_far_reach(u32 metric, u32 reach, u32 radius) {
    return metric != METRIC_MIN && reach / 4u > radius / 256u;
}

// A kernel that looks for a line's widest free radius reads at most MOST_LOOKS rows of pixels, and
// of each at most MOST_LOOKS words of bits, because lavapipe bounds the turns that an invocation's
// loops may take (failure.h).
#define MOST_LOOKS 32u

LACUNA_END

#endif
