// Strips: [x, x + width) times [begin, end), and how far their heights are from a sample's.
#ifndef LACUNA_PORTABLE_STRIP_H
#define LACUNA_PORTABLE_STRIP_H
#include "prelude.h"

LACUNA_BEGIN

// The distance of y from the nearest of the heights [begin, end), and from the farthest: below
// 2^32, also where heights are those of an image outside the domain.
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

LACUNA_END

#endif
