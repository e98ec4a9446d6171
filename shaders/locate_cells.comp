// locate in mode cells: the rank of each draw, walked to a y over the bits of its line.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#include "portable/bits.h"
#include "portable/failure.h"
#include "portable/fate.h"
#include "portable/geometry.h"

layout(local_size_x_id = 0) in;

#ifdef ENTRY_locate_in_cells
// An invocation serves `chunk` draws in a row. A line has so many `words` of bits, set where it is
// free. Candidates are then sorted by sort_columns.
layout(push_constant) uniform Arguments { u32 first_item; Geometry g; u32 words; u32 draw_count;
                                          u32 chunk; };
layout(binding = 0) readonly restrict buffer Bits { u32 bits[]; };
layout(binding = 1) readonly restrict buffer Draws { uvec4 draws[]; };
layout(binding = 2) writeonly restrict buffer Located { uvec4 located[]; };
layout(binding = 3) coherent restrict buffer Failure { u32 failure; };

void main() {
    const u32 begin = (first_item + gl_GlobalInvocationID.x) * chunk;
    const u32 end = min(begin + chunk, draw_count);
    u32 line = NO_SAMPLE;
    u32 at = 0u;
    u32 passed = 0u;
    u32 word = 0u;
    for (u32 i = begin; i < end; ++i) {
        // A draw is line, rank, offset, order. A line's draws ascend in rank.
        const uvec4 draw = draws[i];
        if (draw.x != line) {
            line = draw.x;
            at = 0u;
            passed = 0u;
            word = bits[line * words];
        }

        // Walk the line's words until the rank falls into one.
        u32 free_bits = count_bits(word);
        while (draw.y - passed >= free_bits) {
            passed += free_bits;
            ++at;
            word = bits[line * words + at];
            free_bits = count_bits(word);
        }

        // A candidate is x, y, line, order.
        located[i] = uvec4(line, at * 32u + bit_of_rank(word, draw.y - passed), line, draw.w);
    }
    if (!has_turns_left(g.height)) atomicOr(failure, FAILED_LOCATE);
}
#endif

#ifdef ENTRY_look_up_radii
// The radius of each candidate: that of its pixel, one of `rows` in a column.
layout(push_constant) uniform Arguments { u32 first_item; u32 rows; u32 draw_count; };
layout(binding = 0) readonly restrict buffer Candidates { uvec4 candidates[]; };
layout(binding = 1) readonly restrict buffer ColumnOf { u32 column_of[]; };
layout(binding = 2) readonly restrict buffer RowOf { u32 row_of[]; };
layout(binding = 3) readonly restrict buffer PixelRadii { u32 pixel_radii[]; };
layout(binding = 4) writeonly restrict buffer CandidateRadii { u32 candidate_radii[]; };

void main() {
    const u32 i = first_item + gl_GlobalInvocationID.x;
    if (i >= draw_count) return;
    const uvec4 candidate = candidates[i];
    candidate_radii[i] = pixel_radii[column_of[candidate.x] * rows + row_of[candidate.y]];
}
#endif
