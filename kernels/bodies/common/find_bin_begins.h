// The body of find_bin_begins: finds the first box of each column, and finally the number of boxes.
// Boxes are ordered by line.
#include "portable/column.h"

BODY void serve_find_bin_begins(MEMORY const ColumnArguments a, const u32 column) {
    if (column > a.g.columns) return;
    const u32 line = first_line_of_column(column, a.g.lines, a.g.columns);
    u32 begin = 0u;
    u32 end = min(AT(report, TOTAL_WORD) - AT(report, SAMPLES_WORD), a.room);
    while (begin < end) {
        const u32 middle = begin + (end - begin) / 2u;
        if (LOAD(Box, new_boxes, middle).x / a.g.strip_width < line)
            begin = middle + 1u;
        else
            end = middle;
    }
    AT(bin_begins, column) = begin;
}
