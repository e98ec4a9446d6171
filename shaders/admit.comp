// admit: a candidate becomes a sample unless an earlier sample of the round covers it. Earlier is
// by the order of the draws, whatever the order of the work.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#include "portable/sample_grid.h"
#include "portable/column.h"
#include "portable/distance.h"
#include "portable/failure.h"
#include "portable/fate.h"
#include "portable/geometry.h"
#include "portable/window.h"

layout(local_size_x_id = 0) in;

#ifdef ENTRY_screen
// In exact, before the first pass: settles the candidates that samples of earlier rounds cover.
layout(push_constant) uniform Arguments { u32 first_item; Geometry g; u32 draw_count; u32 chunk; };
layout(binding = 0) readonly restrict buffer Candidates { uvec4 candidates[]; };
layout(binding = 1) readonly restrict buffer GridX { u32 grid_x[]; };
layout(binding = 2) readonly restrict buffer GridY { u32 grid_y[]; };
layout(binding = 3) restrict buffer Fates { u32 fates[]; };
layout(binding = 4) writeonly restrict buffer Samples { uvec2 samples[]; };

// Whether a sample is closer than the radius. No branch: where samples lie cannot be foretold, and
// lavapipe's loads of neighbouring invocations are a loop over those that take part.
bool is_covered_at(const u32 x, const u32 y) {
    const GridStretch columns =
        grid_stretch(x, x + 1u, g.radius, g.width, g.period_x, g.grid_side, g.grid_columns);
    const GridStretch rows =
        grid_stretch(y, y + 1u, g.radius, g.height, g.period_y, g.grid_side, g.grid_rows);
    bool is_covered = false;
    for (u32 i = 0u; i < columns.count; ++i) {
        const u32 cell_column = nth_of_stretch(columns, i, g.grid_columns) * g.grid_rows;
        for (u32 j = 0u; j < rows.count; ++j) {
            const u32 cell = cell_column + nth_of_stretch(rows, j, g.grid_rows);
            const u32 sample_x = grid_x[cell];
            const u32 sample_y = grid_y[cell];
            const bool is_close = conflicts(sample_x, sample_y, x, y, g.period_x, g.period_y,
                                            g.radius_squared);
            is_covered = is_covered || (is_close && sample_x != NO_SAMPLE);
        }
    }
    return is_covered;
}

void main() {
    const u32 begin = (first_item + gl_GlobalInvocationID.x) * chunk;
    const u32 end = min(begin + chunk, draw_count);
    for (u32 i = begin; i < end; ++i) {
        if (fates[i] != FATE_UNDECIDED) continue;
        const uvec4 candidate = candidates[i];
        if (!is_covered_at(candidate.x, candidate.y)) continue;
        fates[i] = FATE_COVERED;
        samples[candidate.w] = uvec2(NO_SAMPLE, FATE_COVERED);
    }
}
#endif

#ifdef ENTRY_admit
layout(push_constant) uniform Arguments { u32 first_item; Geometry g; u32 pass;
                                          u32 draw_count; u32 chunk; };
layout(binding = 0) readonly restrict buffer ColumnBegins { u32 column_begins[]; };
layout(binding = 1) readonly restrict buffer Buckets { u32 buckets[]; };
layout(binding = 2) readonly restrict buffer Candidates { uvec4 candidates[]; };
layout(binding = 3) coherent restrict buffer Fates { u32 fates[]; };
layout(binding = 4) coherent restrict buffer Undecided { u32 undecided[]; };
layout(binding = 5) writeonly restrict buffer Samples { uvec2 samples[]; };
layout(binding = 6) coherent restrict buffer Failure { u32 failure; };

// A candidate of the column [begin, end) that is not above the first whose y is at least low, but
// seldom far below it.
u32 lower_bound(const u32 begin, const u32 end, const u32 low) {
    const u32 bucket = bucket_of(low, end - begin, g.height);
    return bucket > 0u ? buckets[begin + bucket - 1u] : begin;
}

// What can be said of a candidate now. Invocations of one pass read each other's fates while they
// are decided; whatever they see, a fate once decided is the right one.
u32 decide(const uvec4 candidate) {
    // On a line, what counts is the chord on that line.
    const u32 centre = candidate.z * g.strip_width + g.strip_width / 2u;
    const u32 x = g.is_exact != 0u ? candidate.x : centre;
    const u32 column = column_of_line(candidate.z, g.lines, g.columns);
    const u32 first = first_neighbour(column, g.columns, g.period_x);
    const u32 count = neighbour_count(column, g.columns, g.period_x);
    const bool is_at_edge = candidate.y < g.radius || g.height - candidate.y <= g.radius;
    const u32 windows = g.period_y != 0u && is_at_edge ? 3u : 1u;

    // Look at all earlier candidates within reach.
    bool waits = false;
    for (u32 k = 0u; k < count; ++k) {
        const u32 neighbour = (first + k) % g.columns;
        const u32 begin = column_begins[neighbour];
        const u32 end = column_begins[neighbour + 1u];
        for (u32 window = 0u; window < windows; ++window) {
            const u32 low = window_low(window, candidate.y, g.radius, g.height);
            const u32 high = window_high(window, candidate.y, g.radius, g.height);
            u32 j = low > high ? end : lower_bound(begin, end, low);
            for (; j < end; ++j) {
                const uvec4 other = candidates[j];
                if (other.y > high) break;
                if (other.y < low || other.w >= candidate.w) continue;
                if (!conflicts(other.x, other.y, x, candidate.y, g.period_x, g.period_y,
                               g.radius_squared))
                    continue;
                // A sample covers this candidate for good; an undecided one may yet.
                const u32 fate = atomicOr(fates[j], 0u);
                if (fate == FATE_ADMITTED) return FATE_REJECTED;
                waits = waits || fate == FATE_UNDECIDED;
            }
        }
    }
    return waits ? FATE_UNDECIDED : FATE_ADMITTED;
}

// One pass over all candidates. undecided[pass] counts those it leaves; a pass after one that left
// none has nothing to do. samples[order] is where the host looks for the sample of that draw.
void main() {
    if (pass > 0u && undecided[pass - 1u] == 0u) return;
    const u32 begin = (first_item + gl_GlobalInvocationID.x) * chunk;
    const u32 end = min(begin + chunk, draw_count);
    for (u32 i = begin; i < end; ++i) {
        // Invocations in lockstep look for work together.
        while (i < end && fates[i] != FATE_UNDECIDED) ++i;
        if (i == end) break;
        const uvec4 candidate = candidates[i];
        const u32 fate = decide(candidate);
        if (fate == FATE_UNDECIDED) {
            atomicAdd(undecided[pass], 1u);
            continue;
        }
        atomicExchange(fates[i], fate);
        samples[candidate.w] = fate == FATE_ADMITTED ? uvec2(candidate.x, candidate.y)
                                                     : uvec2(NO_SAMPLE, fate);
    }
    if (!has_turns_left(g.height)) atomicOr(failure, FAILED_ADMIT);
}
#endif
