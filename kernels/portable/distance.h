// Distances on the domain, torus or box, and the conflict of two samples.
#ifndef LACUNA_PORTABLE_DISTANCE_H
#define LACUNA_PORTABLE_DISTANCE_H
#include "prelude.h"

LACUNA_BEGIN

// Distance of a and b on one axis. The axis wraps after `period` units; 0: it does not wrap.
LACUNA_FN u32 axis_distance(u32 a, u32 b, u32 period) {
    u32 straight = a > b ? a - b : b - a;
    u32 around = period - straight;
    return period != 0u && around < straight ? around : straight;
}

// At most 2^63 for coordinates of at most 2^31.
LACUNA_FN u64 squared_length(u32 dx, u32 dy) {
    u64 x = dx;
    u64 y = dy;
    return x * x + y * y;
}

// How far `at` is from the nearest and from the farthest of the places begin .. last of an axis
// that does not wrap between them. With one place they are alike.
LACUNA_FN u32 near_distance(u32 at, u32 begin, u32 last) {
    u32 below = begin > at ? begin - at : 0u;
    u32 above = at > last ? at - last : 0u;
    return below > above ? below : above;
}

LACUNA_FN u32 far_distance(u32 at, u32 begin, u32 last) {
    u32 to_begin = at > begin ? at - begin : 0u;
    u32 to_last = last > at ? last - at : 0u;
    return to_begin > to_last ? to_begin : to_last;
}

// Two points conflict when they are strictly closer than the radius.
LACUNA_FN bool conflicts(u32 ax, u32 ay, u32 bx, u32 by, u32 period_x, u32 period_y,
                         u64 radius_squared) {
    return squared_length(axis_distance(ax, bx, period_x), axis_distance(ay, by, period_y)) <
           radius_squared;
}

LACUNA_END

#endif
