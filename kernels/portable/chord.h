// The chord of a line inside a sample's disk (section 4.1): the part that the sample takes from it.
#ifndef LACUNA_PORTABLE_CHORD_H
#define LACUNA_PORTABLE_CHORD_H
#include "isqrt.h"

LACUNA_BEGIN

// The number of whole t >= 0 with dx^2 + t^2 < radius_squared. A line at distance dx from a sample
// at height y loses every y' with |y' - y| < chord_reach. 0 means that the line is not cut.
LACUNA_FN u32 chord_reach(u32 dx, u64 radius_squared) {
    u64 x = dx;
    u64 x_squared = x * x;
    bool is_cut = x_squared < radius_squared;
    u64 root = isqrt(is_cut ? radius_squared - x_squared - 1u : 0u);
    return is_cut ? to_u32(root) + 1u : 0u;
}

// The heights closer to y than `reach`, as windows [begin, end): one on a box, three on a torus.
// Window 0 is around y. Window 1 is the part below 0, which appears at the top; window 2 is the
// part above the top, which appears at the bottom. A window is empty unless begin < end. A reach
// beyond the height is cut to the height: it covers as much, and sums stay within 32 bits.
LACUNA_FN u32 window_begin(u32 window, u32 y, u32 reach, u32 height) {
    u32 cut = reach < height ? reach : height;
    bool is_below = y + 1u < cut;
    if (window == 0u) return is_below ? 0u : y + 1u - cut;
    return window == 1u ? (is_below ? y + 1u + (height - cut) : height) : 0u;
}

LACUNA_FN u32 window_end(u32 window, u32 y, u32 reach, u32 height) {
    u32 end = y + (reach < height ? reach : height);
    if (window == 0u) return end < height ? end : height;
    return window == 1u ? height : end > height ? end - height : 0u;
}

LACUNA_END

#endif
