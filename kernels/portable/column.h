// Columns: runs of neighbouring lines at least as wide as the radius, so that all that touches a
// line lies in its own column or the one on either side. Work is binned and shared out by column.
#ifndef LACUNA_PORTABLE_COLUMN_H
#define LACUNA_PORTABLE_COLUMN_H
#include "prelude.h"

LACUNA_BEGIN

// The first line of a column; that of column `columns` is `lines`.
LACUNA_FN u32 first_line_of_column(u32 column, u32 lines, u32 columns) {
    u64 scaled = column;
    return to_u32((scaled * lines + columns - 1u) / columns);
}

LACUNA_FN u32 column_of_line(u32 line, u32 lines, u32 columns) {
    u64 scaled = line;
    return to_u32(scaled * columns / lines);
}

// A column's neighbours, itself included, are first_neighbour + 0, 1, ... modulo `columns`, each
// once. `wraps` is 0 on a box.
LACUNA_FN u32 neighbour_count(u32 column, u32 columns, u32 wraps) {
    if (wraps != 0u) return columns < 3u ? columns : 3u;
    u32 below = column > 0u ? 1u : 0u;
    u32 above = column + 1u < columns ? 1u : 0u;
    return below + 1u + above;
}

LACUNA_FN u32 first_neighbour(u32 column, u32 columns, u32 wraps) {
    if (wraps == 0u) return column > 0u ? column - 1u : 0u;
    return columns < 3u ? 0u : (column + columns - 1u) % columns;
}

// A stretch of lines, or of columns: first + 0, 1, ... modulo their number, each once.
struct Stretch {
    u32 first;
    u32 count;
};
LACUNA_TYPEDEF(Stretch)

// The lines at most `reach` lines away. `wraps` is 0 on a box.
LACUNA_FN Stretch near_lines(u32 line, u32 reach, u32 lines, u32 wraps) {
    u64 around = reach;
    bool is_all = wraps != 0u && around * 2u + 1u >= lines;
    bool is_below = line < reach;
    bool is_above = around + line >= lines;
    u32 low = is_below ? (wraps != 0u ? line + (lines - reach) : 0u) : line - reach;
    u32 high = is_above ? lines - 1u : line + reach;
    Stretch near;
    near.first = is_all ? 0u : low;
    near.count = is_all ? lines : wraps != 0u ? 2u * reach + 1u : high - low + 1u;
    return near;
}

// The columns that a stretch of lines touches.
LACUNA_FN Stretch near_columns(Stretch near, u32 lines, u32 columns) {
    u32 last = near.first + (near.count - 1u);
    bool is_wrapped = last >= lines;
    Stretch touched;
    touched.first = column_of_line(near.first, lines, columns);
    u32 end = column_of_line(is_wrapped ? last - lines : last, lines, columns) + 1u;
    u32 count = end + (is_wrapped ? columns : 0u) - touched.first;
    touched.count = count < columns ? count : columns;
    return touched;
}

// A column's `count` candidates are sorted by y by way of `count` buckets, and found by their
// height again: bucket_of tells the bucket of a height below `height`. All buckets are equally
// high. Heights are shifted up until `height` fills 32 bits, and then scaled by a multiplication,
// because devices take long to divide: of the `count` buckets at least the lower half has heights,
// the others none.
LACUNA_FN u32 bucket_of(u32 y, u32 count, u32 height) {
    u64 scaled = y << leading_zeros(height);
    return to_u32(scaled * count >> 32u);
}

LACUNA_END

#endif
