// The chord of a line inside a sample's disk (section 4.1): what one sample takes from one line.
#ifndef LACUNA_PORTABLE_CHORD_H
#define LACUNA_PORTABLE_CHORD_H
#include "isqrt.h"

LACUNA_BEGIN

// How many whole numbers t >= 0 have dx^2 + t^2 < radius_squared: the chord of a line at distance
// dx from a sample at height y is every y' with |y' - y| < chord_reach. 0: the line is not cut.
LACUNA_FN u32 chord_reach(u32 dx, u64 radius_squared) {
    u64 x = dx;
    u64 x_squared = x * x;
    bool is_cut = x_squared < radius_squared;
    u64 root = isqrt(is_cut ? radius_squared - x_squared - 1u : 0u);
    return is_cut ? to_u32(root) + 1u : 0u;
}

// The chord at height y is [chord_begin, chord_end) where it stays inside [0, height). A reach
// beyond the height is cut to the height, which covers as much and keeps the sums in 32 bits.
LACUNA_FN u32 chord_begin(u32 y, u32 reach) {
    return y >= reach ? y - reach + 1u : 0u;
}

LACUNA_FN u32 chord_end(u32 y, u32 reach, u32 height) {
    u32 end = y + (reach < height ? reach : height);
    return end < height ? end : height;
}

// What of the chord sticks out above the top wraps to [0, chord_wrapped_end), 0 for nothing; what
// sticks out below 0 wraps to [chord_wrapped_begin, height), `height` for nothing.
LACUNA_FN u32 chord_wrapped_end(u32 y, u32 reach, u32 height) {
    u32 end = y + (reach < height ? reach : height);
    return end > height ? end - height : 0u;
}

LACUNA_FN u32 chord_wrapped_begin(u32 y, u32 reach, u32 height) {
    u32 cut = reach < height ? reach : height;
    return y + 1u < cut ? y + 1u + (height - cut) : height;
}

LACUNA_END

#endif
