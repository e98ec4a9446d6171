// The factor of two samples' classes (portable/sheets.h), from the table of the plan.
#ifndef LACUNA_BODIES_FACTOR_H
#define LACUNA_BODIES_FACTOR_H
#include "portable/sheets.h"

// With one class the table is not read.
BODY u64 factor_of(MEMORY const Geometry g, const u32 x_a, const u32 x_b) {
    if (g.sheet_bits == BITS_OF_ONE_SHEET) return FACTOR_ONE;
    const Wide factor = LOAD(
        Wide, factors, sheet_of(x_a, g.sheet_bits) * MOST_CLASSES + sheet_of(x_b, g.sheet_bits));
    return (to_u64(factor.high) << 32) + factor.low;
}

#endif
