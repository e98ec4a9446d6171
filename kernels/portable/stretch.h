// Stretches: runs of lines, columns or cells on an axis that may wrap.
#ifndef LACUNA_PORTABLE_STRETCH_H
#define LACUNA_PORTABLE_STRETCH_H
#include "types.h"

LACUNA_BEGIN

// Lines, columns or cells first + 0, 1, ..., modulo their number on the axis.
struct Stretch {
    u32 first;
    u32 count;
};
LACUNA_TYPEDEF(Stretch)

// The cells of an axis, each `side` units long, that are at most `reach` units from [begin, end).
// The axis has `length` units and `cells` cells, and wraps if `wraps` is not 0. If it wraps, the
// first cell may occur twice, the second time at the end.
LACUNA_FN Stretch cells_near(u32 begin, u32 end, u32 reach, u32 length, u32 wraps, u32 side,
                             u32 cells) {
    u64 around = reach;
    bool is_all = wraps != 0u && around * 2u + (end - begin) >= length;
    bool is_below = begin < reach;
    bool is_above = around + end > length;
    bool is_wrapped = wraps != 0u && !is_all && (is_below || is_above);
    u32 low = is_below ? (is_wrapped ? begin + (length - reach) : 0u) : begin - reach;
    u32 high = is_above ? (is_wrapped ? to_u32(around + end - length) : length) : end + reach;
    Stretch near;
    near.first = is_all ? 0u : low / side;
    u32 straight = (high - 1u) / side + 1u - near.first;
    near.count = is_all ? cells : straight + (is_wrapped ? cells : 0u);
    return near;
}

// The lines, or columns, at most `reach` away from line `at`, each once; the axis has `length`.
LACUNA_FN Stretch stretch_around(u32 at, u32 reach, u32 length, u32 wraps) {
    return cells_near(at, at + 1u, reach, length, wraps, 1u, length);
}

// Element i of a stretch on an axis with `length` elements.
LACUNA_FN u32 nth_of_stretch(Stretch stretch, u32 i, u32 length) {
    u32 at = stretch.first + i;
    return at < length ? at : at - length;
}

LACUNA_END

#endif
