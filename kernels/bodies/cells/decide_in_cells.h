// Searches the columns nearby for an earlier sample of the round that conflicts with a candidate.
// It is included after limit_in_cells.h, which has the conflict rule.
#include "portable/chord.h"
#include "portable/distance.h"

// Index of a candidate in the column [begin, end) from which to search heights >= low. It is never
// after the first such candidate, and rarely far before it.
BODY u32 lower_bound(MEMORY const u32 begin, const u32 end, const u32 low, const u32 height) {
    const u32 bucket = bucket_of(low, end - begin, height);
    return bucket > 0u ? AT(buckets, begin + bucket - 1u) : begin;
}

// The status of candidate i as far as it can be decided now, plus four times the number of others
// looked at. Items of one pass read statuses that other items are writing; whatever they read, a
// decided status is final.
BODY u32 decide(MEMORY const DrawArguments a, const u32 i, const Candidate candidate) {
    const u32 height = a.g.height;
    const u32 x = place_of(a, candidate);
    const u32 reach = reach_of(ON a, candidate);
    const Stretch columns = columns_near(a, candidate, reach);
    const bool is_at_edge = candidate.y < reach || height - candidate.y <= reach;
    const u32 windows = a.g.period_y != 0u && is_at_edge ? 3u : 1u;

    // Look at all earlier candidates within reach.
    bool waits = false;
    u32 looks = 0u;
    for (u32 k = 0u; k < columns.count; ++k) {
        const u32 column = nth_of_stretch(columns, k, a.g.columns);
        const u32 begin = AT(column_begins, column);
        const u32 end = AT(column_begins, column + 1u);
        for (u32 window = 0u; window < windows; ++window) {
            const u32 low = window_begin(window, candidate.y, reach, height);
            const u32 high = window_end(window, candidate.y, reach, height);
            const u32 from = low >= high ? end : lower_bound(ON begin, end, low, height);
            u32 j = from;
            for (; j < end; ++j) {
                const Candidate other = LOAD(Candidate, candidates, j);
                if (other.y >= high) break;
                if (other.y < low || other.order >= candidate.order) continue;
                if (!are_closer(other.x, other.y, x, candidate.y, a.g.period_x, a.g.period_y,
                                limit_of(ON a, i, j)))
                    continue;
                // An admitted candidate rejects this one; an undecided one may reject it later.
                const u32 status = ATOMIC_OR(statuses, j, 0u);
                if (status == STATUS_ADMITTED) return STATUS_REJECTED + 4u * (looks + j - from);
                waits = waits || status == STATUS_UNDECIDED;
            }
            looks += j - from;
        }
    }
    return waits ? STATUS_UNDECIDED + 4u * looks : STATUS_ADMITTED + 4u * looks;
}
