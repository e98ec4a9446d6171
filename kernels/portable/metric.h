// The distance that two samples of different radii must keep (section 4.2.1), on the lattice of
// mode cells. Radii are in units of 1/256 of a lattice step.
#ifndef LACUNA_PORTABLE_METRIC_H
#define LACUNA_PORTABLE_METRIC_H
#include "types.h"

#define METRIC_MIN 0u
#define METRIC_MEAN 1u
#define METRIC_MAX 2u

LACUNA_BEGIN

// The radius for a pair of radii, doubled so that the mean is a whole number.
LACUNA_FN u32 twice_metric_radius(u32 metric, u32 a, u32 b) {
    if (metric == METRIC_MEAN) return a + b;
    bool is_a = metric == METRIC_MIN ? a < b : a > b;
    return 2u * (is_a ? a : b);
}

// Radii are sorted into classes, four for each power of 2: a class ignores this many low bits.
LACUNA_FN u32 low_bits_of_class(u32 radius) {
    return radius < 8u ? 0u : 29u - leading_zeros(radius);
}

#define RADIUS_CLASSES 124u
LACUNA_FN u32 radius_class(u32 radius) {
    u32 low_bits = low_bits_of_class(radius);
    return low_bits * 4u + (radius >> low_bits);
}

// The largest radius in the class of `radius`.
LACUNA_FN u32 class_bound(u32 radius) {
    return radius | ((1u << low_bits_of_class(radius)) - 1u);
}

// Points conflict if their squared distance in steps is below this. `twice` >= 1 is in 1/512 step.
LACUNA_FN u64 metric_squared(u32 twice) {
    u64 wide = twice;
    return ((wide * wide - 1u) >> 18u) + 1u;
}

// With mean and max a sample may block points up to `reach` lattice steps away, farther than its
// `radius`, but only points whose own radius is large. If the reach is over four times the radius,
// it saves time to look up the widest radius that is still free on each line
// (RadiusMap::widest_rows), and to go no farther than it requires.
LACUNA_FN bool is_far_reach(u32 metric, u32 reach, u32 radius) {
    return metric != METRIC_MIN && reach / 4u > radius / 256u;
}

// Most rows of pixels, and most words of bits of each, that a kernel reads to find a line's widest
// free radius. The limit exists because lavapipe bounds the turns of an invocation's loops
// (failure.h).
#define MOST_LOOKS 32u

LACUNA_END

#endif
