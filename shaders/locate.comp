// locate: the rank of each draw, walked to a y through its line's free spans; then the order of y
// within each column, which admit and subtract rely on.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#include "portable/column.h"
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

void main() {
    const u32 begin = first_draw + (first_item + gl_GlobalInvocationID.x) * chunk;
    const u32 end = min(begin + chunk, end_draw);
    for (u32 i = begin; i < end; ++i) {
        // A draw is line, rank, x, order.
        const uvec4 draw = draws[i];
        const u32 line = draw.x;

        // Walk the line's spans until the rank falls into one.
        u32 at = (line - first_line) * g.capacity;
        u32 rank = draw.y;
        uvec2 span = spans[at];
        while (rank >= span.y - span.x) {
            rank -= span.y - span.x;
            ++at;
            span = spans[at];
        }

        // A candidate is x, y, line, order.
        located[i] = uvec4(draw.z, span.x + rank, line, draw.w);
    }
}
#endif

#ifdef ENTRY_sort_columns
// Sorts the candidates of each column by y, and by order where y is equal: the place of one is the
// number of those before it.
layout(push_constant) uniform Arguments { u32 first_item; Geometry g; u32 draws; u32 chunk; };
layout(binding = 0) readonly restrict buffer ColumnBegins { u32 column_begins[]; };
layout(binding = 1) readonly restrict buffer Located { uvec4 located[]; };
layout(binding = 2) writeonly restrict buffer Candidates { uvec4 candidates[]; };
layout(binding = 3) writeonly restrict buffer Fates { u32 fates[]; };

void main() {
    const u32 begin = (first_item + gl_GlobalInvocationID.x) * chunk;
    const u32 end = min(begin + chunk, draws);
    for (u32 i = begin; i < end; ++i) {
        const uvec4 candidate = located[i];
        const u32 column = column_of_line(candidate.z, g.lines, g.columns);
        const u32 column_begin = column_begins[column];
        const u32 column_end = column_begins[column + 1u];

        // Count those before this one.
        u32 place = column_begin;
        for (u32 j = column_begin; j < column_end; ++j) {
            const uvec4 other = located[j];
            place += u32(other.y < candidate.y ||
                         (other.y == candidate.y && other.w < candidate.w));
        }
        candidates[place] = candidate;
        fates[i] = FATE_UNDECIDED;
    }
}
#endif
