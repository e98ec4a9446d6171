// locate: the rank of each draw, walked to a y through its place's free length; then the order of y
// within each column, which admit and subtract rely on.
#include "portable/failure.h"
#include "portable/fate.h"
#include "portable/geometry.h"

// A work item serves `chunk` draws in a row of [first_draw, end_draw): long chunks for processors,
// 1 for graphics cards. `spans` holds the lines from first_line on.
kernel void locate(const Geometry g, const u32 first_line, const u32 first_draw,
                   const u32 end_draw, const u32 chunk, global const uint2* restrict spans,
                   global const uint4* restrict draws, global uint4* restrict located,
                   volatile global u32* failure) {
    const u32 begin = first_draw + (u32)get_global_id(0) * chunk;
    const u32 end = min(begin + chunk, end_draw);
    u32 line = NO_SAMPLE;
    u64 at = 0u;
    u32 passed = 0u;
    uint2 span = (uint2)(0u, 0u);
    for (u32 i = begin; i < end; ++i) {
        // A draw is line, rank, offset, order. A line's draws ascend in rank.
        const uint4 draw = draws[i];
        if (draw.x != line) {
            line = draw.x;
            at = (u64)(line - first_line) * g.capacity;
            passed = 0u;
            span = spans[at];
        }

        // Walk the line's spans until the rank falls into one.
        while (draw.y - passed >= span.y - span.x) {
            passed += span.y - span.x;
            ++at;
            span = spans[at];
        }

        // A candidate is x, y, line, order.
        located[i] = (uint4)(line * g.strip_width + draw.z, span.x + (draw.y - passed), line,
                             draw.w);
    }
    if (!has_turns_left(g.height)) atomic_or(failure, FAILED_LOCATE);
}

// The same for draws of boxes.
kernel void locate_in_boxes(const Geometry g, const u32 draw_count, const u32 chunk,
                            global const u32* restrict box_x,
                            global const u32* restrict box_begin,
                            global const uint4* restrict draws, global uint4* restrict located) {
    const u32 begin = (u32)get_global_id(0) * chunk;
    const u32 end = min(begin + chunk, draw_count);
    for (u32 i = begin; i < end; ++i) {
        const uint4 draw = draws[i];
        const u32 x = box_x[draw.x];
        located[i] = (uint4)(x + draw.z, box_begin[draw.x] + draw.y, x / g.strip_width, draw.w);
    }
}

bool comes_before(const uint4 a, const uint4 b) {
    return a.y < b.y || (a.y == b.y && a.w < b.w);
}

// Sorts the candidates of each column by y, and by order where y is equal. The buckets of a column
// are in its part of `buckets`: most of the work is to find a draw's. All
// candidates are then pending for admit.
kernel void sort_columns(const Geometry g, global const u32* restrict column_begins,
                         global const uint4* restrict located, global u32* restrict buckets,
                         global uint4* restrict candidates, global u32* restrict fates,
                         global u32* restrict pending, volatile global u32* failure) {
    const u32 column = (u32)get_global_id(0);
    if (column >= g.columns) return;
    const u32 begin = column_begins[column];
    const u32 end = column_begins[column + 1u];
    if (begin == end) return;
    const u32 count = end - begin;

    // Count the draws of each bucket.
    for (u32 i = begin; i < end; ++i) buckets[i] = 0u;
    for (u32 i = begin; i < end; ++i)
        ++buckets[begin + bucket_of(located[i].y, count, g.height)];

    // Find where each begins.
    u32 sum = begin;
    for (u32 i = begin; i < end; ++i) {
        const u32 in_bucket = buckets[i];
        buckets[i] = sum;
        sum += in_bucket;
    }

    // Share the draws out.
    for (u32 i = begin; i < end; ++i) {
        const uint4 candidate = located[i];
        const u32 bucket = begin + bucket_of(candidate.y, count, g.height);
        candidates[buckets[bucket]] = candidate;
        ++buckets[bucket];
        fates[i] = FATE_UNDECIDED;
        pending[i] = i;
    }

    // Order those of one bucket: few, so by hand.
    for (u32 i = begin + 1u; i < end; ++i) {
        const uint4 moved = candidates[i];
        u32 to = i;
        while (to > begin && comes_before(moved, candidates[to - 1u])) {
            candidates[to] = candidates[to - 1u];
            --to;
        }
        if (to < i) candidates[to] = moved;
    }
    if (!has_turns_left(g.height)) atomic_or(failure, FAILED_SORT_COLUMNS);
}
