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

// Lattice points conflict when their squared distance in steps is below this. `twice` is at
// least 1.
LACUNA_FN u64 metric_squared(u32 twice) {
    u64 wide = twice;
    return ((wide * wide - 1u) >> 18u) + 1u;
}

LACUNA_END

#endif
