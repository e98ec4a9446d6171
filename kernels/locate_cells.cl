// locate in mode cells: the rank of each draw, walked to a y over the bits of its line.
#include "portable/bits.h"
#include "portable/failure.h"
#include "portable/fate.h"
#include "portable/geometry.h"

// A work item serves `chunk` draws in a row. A line has so many `words` of bits, set where it is
// free. Candidates are then sorted by sort_columns.
kernel void locate_in_cells(const Geometry g, const u32 words, const u32 draw_count,
                            const u32 chunk, global const u32* restrict bits,
                            global const uint4* restrict draws, global uint4* restrict located,
                            volatile global u32* failure) {
    const u32 begin = (u32)get_global_id(0) * chunk;
    const u32 end = min(begin + chunk, draw_count);
    u32 line = NO_SAMPLE;
    u32 at = 0u;
    u32 passed = 0u;
    u32 word = 0u;
    for (u32 i = begin; i < end; ++i) {
        // A draw is line, rank, offset, order. A line's draws ascend in rank.
        const uint4 draw = draws[i];
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
        located[i] =
            (uint4)(line, at * 32u + bit_of_rank(word, draw.y - passed), line, draw.w);
    }
    if (!has_turns_left(g.height)) atomic_or(failure, FAILED_LOCATE);
}

// The radius of each candidate: that of its pixel, one of `rows` in a column.
kernel void look_up_radii(const u32 rows, const u32 draw_count, const u32 chunk,
                          global const uint4* restrict candidates,
                          global const u32* restrict column_of, global const u32* restrict row_of,
                          global const u32* restrict pixel_radii,
                          global u32* restrict candidate_radii) {
    const u32 begin = (u32)get_global_id(0) * chunk;
    const u32 end = min(begin + chunk, draw_count);
    for (u32 i = begin; i < end; ++i) {
        const uint4 candidate = candidates[i];
        candidate_radii[i] = pixel_radii[column_of[candidate.x] * rows + row_of[candidate.y]];
    }
}
