// Columns: runs of neighbouring lines, at least as wide as the radius. All samples that touch a
// line lie in its own column or a neighbouring one. Columns are the units in which work is divided.
#ifndef LACUNA_PORTABLE_COLUMN_H
#define LACUNA_PORTABLE_COLUMN_H
#include "stretch.h"

LACUNA_BEGIN

// The first line of a column. For column number `columns` it is `lines`.
LACUNA_FN u32 first_line_of_column(u32 column, u32 lines, u32 columns) {
    u64 scaled = column;
    return to_u32((scaled * lines + columns - 1u) / columns);
}

LACUNA_FN u32 column_of_line(u32 line, u32 lines, u32 columns) {
    u64 scaled = line;
    return to_u32(scaled * columns / lines);
}

// The columns that a stretch of lines touches.
LACUNA_FN Stretch columns_of_stretch(Stretch near, u32 lines, u32 columns) {
    u32 last = near.first + (near.count - 1u);
    bool is_wrapped = last >= lines;
    Stretch touched;
    touched.first = column_of_line(near.first, lines, columns);
    u32 end = column_of_line(is_wrapped ? last - lines : last, lines, columns) + 1u;
    u32 count = end + (is_wrapped ? columns : 0u) - touched.first;
    touched.count = count < columns ? count : columns;
    return touched;
}

// A column's `count` candidates are sorted by y with `count` buckets, and looked up by height
// later. bucket_of is the bucket of a height below `height`; all buckets are equally high. Heights
// are shifted up until `height` fills 32 bits and then scaled by a multiplication, because devices
// divide slowly. So at least the lower half of the buckets is in use, and the others stay empty.
LACUNA_FN u32 bucket_of(u32 y, u32 count, u32 height) {
    u64 scaled = y << leading_zeros(height);
    return to_u32(scaled * count >> 32u);
}

LACUNA_END

#endif
