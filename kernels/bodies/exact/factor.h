// The factor of two samples' classes (portable/class_copies.h), from the table of the plan.
#ifndef LACUNA_BODIES_FACTOR_H
#define LACUNA_BODIES_FACTOR_H
#include "portable/class_copies.h"

// With one class the table is not read.
BODY u64 factor_of(MEMORY const Geometry g, const u32 x_a, const u32 x_b) {
    if (g.copy_bits == BITS_OF_ONE_COPY) return FACTOR_ONE;
    const Wide factor =
        LOAD(Wide, factors, copy_of(x_a, g.copy_bits) * MOST_CLASSES + copy_of(x_b, g.copy_bits));
    return (to_u64(factor.high) << 32) + factor.low;
}

#endif
