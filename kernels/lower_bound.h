// Candidates of a column, found by their y. For kernels alone: shaders look into the buckets.
#ifndef LACUNA_LOWER_BOUND_H
#define LACUNA_LOWER_BOUND_H
#include "portable/prelude.h"

// The first of [begin, end) whose y is at least low.
u32 lower_bound(global const uint4* restrict candidates, u32 begin, u32 end, const u32 low) {
    while (begin < end) {
        const u32 middle = begin + (end - begin) / 2u;
        if (candidates[middle].y < low)
            begin = middle + 1u;
        else
            end = middle;
    }
    return begin;
}

#endif
