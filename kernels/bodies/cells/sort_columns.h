// The body of sort_columns: sorts candidates by y in each column, for admit_in_cells.
#include "portable/column.h"

// If a bucket has more candidates than this, sorting begins with long steps.
#define FEW 16u

BODY bool comes_before(const Candidate a, const Candidate b) {
    return a.y < b.y || (a.y == b.y && a.order < b.order);
}

// Sorts the candidates of one column by y, and by order if y is equal. They go into as many buckets
// as there are candidates, so that few share one, and are then sorted by insertion. `buckets` has a
// word for each candidate; at the end it holds the end of each bucket.
BODY void serve_sort_columns(MEMORY const ColumnArguments a, const u32 column) {
    if (column >= a.g.columns) return;
    const u32 begin = AT(column_begins, column);
    const u32 end = AT(column_begins, column + 1u);
    const u32 count = end - begin;

    // Count the candidates of each bucket.
    for (u32 i = begin; i < end; ++i) {
        AT(buckets, i) = 0u;
        AT(statuses, i) = STATUS_UNDECIDED;
    }
    for (u32 i = begin; i < end; ++i)
        ++AT(buckets, begin + bucket_of(LOAD(Candidate, located, i).y, count, a.g.height));

    // Find the beginning of each bucket, and fill the buckets.
    u32 next = begin;
    u32 largest = 0u;
    for (u32 i = begin; i < end; ++i) {
        const u32 in_bucket = AT(buckets, i);
        AT(buckets, i) = next;
        next += in_bucket;
        largest = max(largest, in_bucket);
    }
    for (u32 i = begin; i < end; ++i) {
        const Candidate candidate = LOAD(Candidate, located, i);
        const u32 bucket = begin + bucket_of(candidate.y, count, a.g.height);
        const u32 to = AT(buckets, bucket);
        AT(buckets, bucket) = to + 1u;
        STORE(candidates, to, candidate);
    }

    // Move each candidate down to its position: a few steps if few share a bucket. If many do, long
    // steps come first (Shell's sort with Ciura's ratio of steps).
    u32 step = largest > FEW ? largest : 1u;
    do {
        step = max(step * 5u / 11u, 1u);
        for (u32 i = begin + step; i < end; ++i) {
            const Candidate moved = LOAD(Candidate, candidates, i);
            u32 to = i;
            while (to >= begin + step &&
                   comes_before(moved, LOAD(Candidate, candidates, to - step))) {
                STORE(candidates, to, LOAD(Candidate, candidates, to - step));
                to -= step;
            }
            if (to < i) STORE(candidates, to, moved);
        }
    } while (step > 1u);
    CHECK_TURNS(a.g.height, FAILED_SORT_COLUMNS);
}
