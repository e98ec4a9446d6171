// admit in mode cells: a candidate becomes a sample unless an earlier sample of the round is closer
// than the metric of their radii allows. See admit.comp for the order of the work.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#include "portable/column.h"
#include "portable/distance.h"
#include "portable/failure.h"
#include "portable/fate.h"
#include "portable/geometry.h"
#include "portable/metric.h"
#include "portable/window.h"

layout(local_size_x_id = 0) in;

layout(push_constant) uniform Arguments { u32 first_item; Geometry g; u32 rows; u32 metric;
                                          u32 pass; u32 draw_count; u32 chunk; };
layout(binding = 0) readonly restrict buffer ColumnBegins { u32 column_begins[]; };
layout(binding = 1) readonly restrict buffer Buckets { u32 buckets[]; };
layout(binding = 2) readonly restrict buffer Candidates { uvec4 candidates[]; };
layout(binding = 3) readonly restrict buffer CandidateRadii { u32 candidate_radii[]; };
layout(binding = 4) readonly restrict buffer ColumnOf { u32 column_of[]; };
layout(binding = 5) readonly restrict buffer RowOf { u32 row_of[]; };
layout(binding = 6) readonly restrict buffer PixelReaches { u32 pixel_reaches[]; };
layout(binding = 7) coherent restrict buffer Fates { u32 fates[]; };
layout(binding = 8) coherent restrict buffer Undecided { u32 undecided[]; };
layout(binding = 9) writeonly restrict buffer Samples { uvec2 samples[]; };
layout(binding = 10) coherent restrict buffer Failure { u32 failure; };

// A candidate of the column [begin, end) that is not above the first whose y is at least low, but
// seldom far below it.
u32 lower_bound(const u32 begin, const u32 end, const u32 low) {
    const u32 bucket = bucket_of(low, end - begin, g.height);
    return bucket > 0u ? buckets[begin + bucket - 1u] : begin;
}

// What can be said of a candidate now, whose conflicts are all within `reach` lattice steps.
// Invocations of one pass read each other's fates while they are decided; whatever they see, a fate
// once decided is the right one.
u32 decide(const uvec4 candidate, const u32 radius, const u32 reach) {
    const Stretch columns =
        near_columns(near_lines(candidate.x, reach, g.lines, g.period_x), g.lines, g.columns);
    const bool is_at_edge = candidate.y < reach || candidate.y + reach >= g.height;
    const u32 windows = g.period_y != 0u && is_at_edge ? 3u : 1u;

    // Look at all earlier candidates within reach.
    bool waits = false;
    for (u32 k = 0u; k < columns.count; ++k) {
        const u32 column = (columns.first + k) % g.columns;
        const u32 begin = column_begins[column];
        const u32 end = column_begins[column + 1u];
        for (u32 window = 0u; window < windows; ++window) {
            const u32 low = window_low(window, candidate.y, reach, g.height);
            const u32 high = window_high(window, candidate.y, reach, g.height);
            u32 j = low > high ? end : lower_bound(begin, end, low);
            for (; j < end; ++j) {
                const uvec4 other = candidates[j];
                if (other.y > high) break;
                if (other.y < low || other.w >= candidate.w) continue;
                const u32 twice = twice_metric_radius(metric, radius, candidate_radii[j]);
                if (!conflicts(other.x, other.y, candidate.x, candidate.y, g.period_x, g.period_y,
                               metric_squared(twice)))
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
// none has nothing to do. samples[order] is where the host looks for what became of that draw.
void main() {
    if (pass > 0u && undecided[pass - 1u] == 0u) return;
    const u32 begin = (first_item + gl_GlobalInvocationID.x) * chunk;
    const u32 end = min(begin + chunk, draw_count);
    for (u32 i = begin; i < end; ++i) {
        // Invocations in lockstep look for work together.
        while (i < end && fates[i] != FATE_UNDECIDED) ++i;
        if (i == end) break;
        const uvec4 candidate = candidates[i];
        const u32 reach = pixel_reaches[column_of[candidate.x] * rows + row_of[candidate.y]];
        const u32 fate = decide(candidate, candidate_radii[i], reach);
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
