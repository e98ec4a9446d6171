// Cells: a grid so fine that two samples never share one, for looking up the samples near a place.
#ifndef LACUNA_PORTABLE_SAMPLE_GRID_H
#define LACUNA_PORTABLE_SAMPLE_GRID_H
#include "isqrt.h"

LACUNA_BEGIN

// floor(r / sqrt 2): two points of one cell are closer than r. For r^2 of at least 2.
LACUNA_FN u32 grid_side(u64 radius_squared) {
    return to_u32(isqrt(radius_squared / 2u));
}

// How many cells cover an axis of `length` units. The last one may stick out.
LACUNA_FN u32 count_grid(u32 length, u32 side) {
    return (length - 1u) / side + 1u;
}

// The cells of one axis within a radius of [begin, end), as one run, which on a torus may go on
// from the last cell to the first.
struct GridStretch {
    u32 first;
    u32 count;
};
LACUNA_TYPEDEF(GridStretch)

// The axis has `count` cells, and wraps after `period` units, 0: it does not wrap.
LACUNA_FN GridStretch grid_stretch(u32 begin, u32 end, u32 radius, u32 length, u32 period, u32 side,
                                   u32 count) {
    u64 around = radius;
    bool is_all = around * 2u + (end - begin) >= length;
    bool is_below = begin < radius;
    bool is_above = around + end > length;
    bool is_wrapped = period != 0u && !is_all && (is_below || is_above);
    u32 low = is_below ? (is_wrapped ? begin + (length - radius) : 0u) : begin - radius;
    u32 high = is_above ? (is_wrapped ? to_u32(around + end - length) : length) : end + radius;
    GridStretch cells;
    cells.first = is_all ? 0u : low / side;
    u32 straight = (high - 1u) / side + 1u - cells.first;
    cells.count = is_all ? count : straight + (is_wrapped ? count : 0u);
    return cells;
}

// The i-th of them.
LACUNA_FN u32 nth_of_stretch(GridStretch cells, u32 i, u32 count) {
    u32 cell = cells.first + i;
    return cell < count ? cell : cell - count;
}

LACUNA_END

#endif
