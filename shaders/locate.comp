// locate: the rank of each draw, walked to a y through its place's free length; then the order of y
// within each column, which admit and subtract rely on.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#include "portable/column.h"
#include "portable/failure.h"
#include "portable/fate.h"
#include "portable/geometry.h"

layout(local_size_x_id = 0) in;

#ifdef ENTRY_locate
// An invocation serves `chunk` draws in a row of [first_draw, end_draw): long chunks for
// processors, 1 for graphics cards. `spans` holds the lines from first_line on.
layout(push_constant) uniform Arguments { u32 first_item; Geometry g; u32 first_line;
                                          u32 first_draw; u32 end_draw; u32 chunk; };
layout(binding = 0) readonly restrict buffer Spans { uvec2 spans[]; };
layout(binding = 1) readonly restrict buffer Draws { uvec4 draws[]; };
layout(binding = 2) writeonly restrict buffer Located { uvec4 located[]; };
layout(binding = 3) coherent restrict buffer Failure { u32 failure; };

void main() {
    const u32 begin = first_draw + (first_item + gl_GlobalInvocationID.x) * chunk;
    const u32 end = min(begin + chunk, end_draw);
    u32 line = NO_SAMPLE;
    u32 at = 0u;
    u32 passed = 0u;
    uvec2 span = uvec2(0u, 0u);
    for (u32 i = begin; i < end; ++i) {
        // A draw is place, rank, offset, order.
        const uvec4 draw = draws[i];
        if (draw.x != line) {
            line = draw.x;
            at = (line - first_line) * g.capacity;
            passed = 0u;
            span = spans[at];
        }

        // Walk the line's spans until the rank falls into one. The next draw of the line has no
        // lower rank: it goes on from there.
        while (draw.y - passed >= span.y - span.x) {
            passed += span.y - span.x;
            ++at;
            span = spans[at];
        }

        // A candidate is x, y, line, order.
        located[i] =
            uvec4(line * g.strip_width + draw.z, span.x + (draw.y - passed), line, draw.w);
    }
    if (!has_turns_left(g.height)) atomicOr(failure, FAILED_LOCATE);
}
#endif

#ifdef ENTRY_locate_in_boxes
// The same for draws whose places are boxes.
layout(push_constant) uniform Arguments { u32 first_item; Geometry g; u32 draw_count; u32 chunk; };
layout(binding = 0) readonly restrict buffer BoxX { u32 box_x[]; };
layout(binding = 1) readonly restrict buffer BoxBegin { u32 box_begin[]; };
layout(binding = 2) readonly restrict buffer Draws { uvec4 draws[]; };
layout(binding = 3) writeonly restrict buffer Located { uvec4 located[]; };

void main() {
    const u32 begin = (first_item + gl_GlobalInvocationID.x) * chunk;
    const u32 end = min(begin + chunk, draw_count);
    for (u32 i = begin; i < end; ++i) {
        const uvec4 draw = draws[i];
        const u32 x = box_x[draw.x];
        located[i] = uvec4(x + draw.z, box_begin[draw.x] + draw.y, x / g.strip_width, draw.w);
    }
}
#endif

#ifdef ENTRY_sort_columns
// Sorts the candidates of one column by y, and by order where y is equal: into as many buckets as
// there are candidates, so that few share one, then by hand. `buckets` has a word for each, which
// in the end tells where the bucket ends among the candidates.
layout(push_constant) uniform Arguments { u32 first_item; Geometry g; };
layout(binding = 0) readonly restrict buffer ColumnBegins { u32 column_begins[]; };
layout(binding = 1) readonly restrict buffer Located { uvec4 located[]; };
layout(binding = 2) restrict buffer Buckets { u32 buckets[]; };
layout(binding = 3) restrict buffer Candidates { uvec4 candidates[]; };
layout(binding = 4) writeonly restrict buffer Fates { u32 fates[]; };
layout(binding = 5) coherent restrict buffer Failure { u32 failure; };

const u32 kFew = 16u;

bool comes_before(const uvec4 a, const uvec4 b) {
    return a.y < b.y || (a.y == b.y && a.w < b.w);
}

void main() {
    const u32 column = first_item + gl_GlobalInvocationID.x;
    if (column >= g.columns) return;
    const u32 begin = column_begins[column];
    const u32 end = column_begins[column + 1u];
    const u32 count = end - begin;

    // Count each bucket's candidates.
    for (u32 i = begin; i < end; ++i) {
        buckets[i] = 0u;
        fates[i] = FATE_UNDECIDED;
    }
    for (u32 i = begin; i < end; ++i) ++buckets[begin + bucket_of(located[i].y, count, g.height)];

    // Find where each bucket begins, and fill them.
    u32 next = begin;
    u32 largest = 0u;
    for (u32 i = begin; i < end; ++i) {
        const u32 in_bucket = buckets[i];
        buckets[i] = next;
        next += in_bucket;
        largest = max(largest, in_bucket);
    }
    for (u32 i = begin; i < end; ++i) {
        const uvec4 candidate = located[i];
        const u32 bucket = begin + bucket_of(candidate.y, count, g.height);
        const u32 to = buckets[bucket];
        buckets[bucket] = to + 1u;
        candidates[to] = candidate;
    }

    // Move each down to its place: a few steps, where few share a bucket. Where many do, by long
    // steps first (Shell's sort, by Ciura's ratio of steps).
    u32 step = largest > kFew ? largest : 1u;
    do {
        step = max(step * 5u / 11u, 1u);
        for (u32 i = begin + step; i < end; ++i) {
            const uvec4 moved = candidates[i];
            u32 to = i;
            while (to >= begin + step && comes_before(moved, candidates[to - step])) {
                candidates[to] = candidates[to - step];
                to -= step;
            }
            if (to < i) candidates[to] = moved;
        }
    } while (step > 1u);
    if (!has_turns_left(g.height)) atomicOr(failure, FAILED_SORT_COLUMNS);
}
#endif
