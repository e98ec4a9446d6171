// The body of collect: lists the samples that may cut a column's lines, ordered by y.
#include "portable/column.h"

// Merges up to three columns: near holds their near_counts[column] samples, from
// near_begins[column] on. Does nothing while admission is unfinished (undecided[last_pass] != 0).
BODY void serve_collect(MEMORY const ColumnArguments a, const u32 column) {
    if (column >= a.g.columns || AT(undecided, a.last_pass) != 0u) return;
    const Stretch columns = stretch_around(column, 1u, a.g.columns, a.g.period_x);
    const u32 second = (columns.first + 1u) % a.g.columns;
    const u32 third = (columns.first + 2u) % a.g.columns;
    u32 i = AT(column_begins, columns.first);
    u32 j = AT(column_begins, second);
    u32 k = AT(column_begins, third);
    const u32 i_end = AT(column_begins, columns.first + 1u);
    const u32 j_end = columns.count > 1u ? AT(column_begins, second + 1u) : j;
    const u32 k_end = columns.count > 2u ? AT(column_begins, third + 1u) : k;

    u32 next = AT(near_begins, column);
    while (true) {
        // Skip candidates that are not samples.
        while (i < i_end && AT(statuses, i) != STATUS_ADMITTED) ++i;
        while (j < j_end && AT(statuses, j) != STATUS_ADMITTED) ++j;
        while (k < k_end && AT(statuses, k) != STATUS_ADMITTED) ++k;

        // Take the lowest y; at equal y the first column's.
        const u32 y_i = i < i_end ? AT(candidates, i).y : NO_SAMPLE;
        const u32 y_j = j < j_end ? AT(candidates, j).y : NO_SAMPLE;
        const u32 y_k = k < k_end ? AT(candidates, k).y : NO_SAMPLE;
        const u32 lowest = min(y_i, min(y_j, y_k));
        if (lowest == NO_SAMPLE) break;
        const u32 taken = y_i == lowest ? i : y_j == lowest ? j : k;
        if (y_i == lowest)
            ++i;
        else if (y_j == lowest)
            ++j;
        else
            ++k;
        AT(near, next) = U32X2(AT(candidates, taken).x, lowest);
        ++next;
    }
    AT(near_counts, column) = next - AT(near_begins, column);
    CHECK_TURNS(a.g.height, FAILED_COLLECT);
}
