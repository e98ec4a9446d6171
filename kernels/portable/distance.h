// Distances on the domain, torus or box.
#ifndef LACUNA_PORTABLE_DISTANCE_H
#define LACUNA_PORTABLE_DISTANCE_H
#include "types.h"

LACUNA_BEGIN

// The distance of a and b on one axis. The axis wraps after `period` units; 0: it does not wrap.
LACUNA_FN u32 axis_distance(u32 a, u32 b, u32 period) {
    u32 straight = a > b ? a - b : b - a;
    u32 around = period - straight;
    return period != 0u && around < straight ? around : straight;
}

// At most 2^63 if the coordinates are at most 2^31.
LACUNA_FN u64 squared_length(u32 dx, u32 dy) {
    u64 x = dx;
    u64 y = dy;
    return x * x + y * y;
}

// The distances from y to the nearest and to the farthest of the heights [begin, end). They are
// below 2^32, even if the heights belong to an image outside the domain.
LACUNA_FN u32 nearest_distance(i64 y, i64 begin, i64 end) {
    i64 below = begin - y;
    i64 above = y - (end - 1);
    i64 outside = below > above ? below : above;
    return to_u32(outside > 0 ? outside : 0);
}

LACUNA_FN u32 farthest_distance(i64 y, i64 begin, i64 end) {
    i64 to_begin = y - begin;
    i64 to_last = end - 1 - y;
    return to_u32(to_begin > to_last ? to_begin : to_last);
}

// The distance from `at` to the nearest of [begin, end) on an axis that wraps after `period` units;
// 0: it does not wrap.
LACUNA_FN u32 distance_to_stretch(u32 at, u32 begin, u32 end, u32 period) {
    u32 last = end - 1u;
    u32 straight = at < begin ? begin - at : at > last ? at - last : 0u;
    // The way around the torus, to the other end of [begin, end).
    u32 around = at < begin ? period - last + at : period - at + begin;
    return period != 0u && around < straight ? around : straight;
}

// Whether two points are strictly closer than the radius.
LACUNA_FN bool are_closer(u32 ax, u32 ay, u32 bx, u32 by, u32 period_x, u32 period_y,
                          u64 radius_squared) {
    return squared_length(axis_distance(ax, bx, period_x), axis_distance(ay, by, period_y)) <
           radius_squared;
}

// The same where nothing wraps, in fewer steps. NO_SAMPLE counts as -1.
LACUNA_FN bool are_closer_on_box(u32 ax, u32 ay, u32 bx, u32 by, u64 radius_squared) {
    i64 dx = sign_extended(ax - bx);
    i64 dy = sign_extended(ay - by);
    return dx * dx + dy * dy < to_i64(radius_squared);
}

LACUNA_END

#endif
