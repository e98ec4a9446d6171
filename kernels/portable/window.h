// The stretches of y within a radius of a given y: one on a box, up to three on a torus.
#ifndef LACUNA_PORTABLE_WINDOW_H
#define LACUNA_PORTABLE_WINDOW_H
#include "prelude.h"

LACUNA_BEGIN

// Window 0 lies around y; window 1 is what sticks out below 0, seen from the top; window 2 what
// sticks out above the top, seen from the bottom. 1 and 2 are for a torus: period == height.
// Both ends belong to it; it is empty when the low end is above the high one.
LACUNA_FN u32 window_low(u32 window, u32 y, u32 radius, u32 height) {
    u32 reach = radius < height ? radius : height;
    if (window == 0u) return y > reach ? y - reach : 0u;
    if (window == 1u) return y < reach ? y + (height - reach) : height;
    return y + reach >= height ? 0u : 1u;
}

LACUNA_FN u32 window_high(u32 window, u32 y, u32 radius, u32 height) {
    u32 reach = radius < height ? radius : height;
    if (window == 0u) return y + reach;
    if (window == 1u) return height - 1u;
    return y + reach >= height ? y + reach - height : 0u;
}

LACUNA_END

#endif
