// locate: the rank of each draw, walked to a y through its line's free spans; then the order of y
// within each column, which admit and subtract rely on.
#include "portable/column.h"
#include "portable/fate.h"
#include "portable/geometry.h"

// A work item serves `chunk` draws in a row of [first_draw, end_draw): long chunks for processors,
// 1 for graphics cards. `spans` holds the lines from first_line on.
kernel void locate(const Geometry g, const u32 first_line, const u32 first_draw,
                   const u32 end_draw, const u32 chunk, global const uint2* restrict spans,
                   global const uint4* restrict draws, global uint4* restrict located) {
    const u32 begin = first_draw + (u32)get_global_id(0) * chunk;
    const u32 end = min(begin + chunk, end_draw);
    for (u32 i = begin; i < end; ++i) {
        // A draw is line, rank, x, order.
        const uint4 draw = draws[i];
        const u32 line = draw.x;

        // Walk the line's spans until the rank falls into one.
        u64 at = (u64)(line - first_line) * g.capacity;
        u32 rank = draw.y;
        uint2 span = spans[at];
        while (rank >= span.y - span.x) {
            rank -= span.y - span.x;
            ++at;
            span = spans[at];
        }

        // A candidate is x, y, line, order.
        located[i] = (uint4)(draw.z, span.x + rank, line, draw.w);
    }
}

// Sorts the candidates of each column by y, and by order where y is equal: the place of one is the
// number of those before it.
kernel void sort_columns(const Geometry g, const u32 draws, const u32 chunk,
                         global const u32* restrict column_begins,
                         global const uint4* restrict located, global uint4* restrict candidates,
                         global u32* restrict fates) {
    const u32 begin = (u32)get_global_id(0) * chunk;
    const u32 end = min(begin + chunk, draws);
    for (u32 i = begin; i < end; ++i) {
        const uint4 candidate = located[i];
        const u32 column = column_of_line(candidate.z, g.lines, g.columns);
        const u32 column_begin = column_begins[column];
        const u32 column_end = column_begins[column + 1u];

        // Count those before this one.
        u32 place = column_begin;
        for (u32 j = column_begin; j < column_end; ++j) {
            const uint4 other = located[j];
            place += other.y < candidate.y || (other.y == candidate.y && other.w < candidate.w);
        }
        candidates[place] = candidate;
        fates[i] = FATE_UNDECIDED;
    }
}
