// admit: a candidate becomes a sample unless an earlier sample of the round covers it. Earlier is
// by the order of the draws, whatever the order of the work.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#include "portable/column.h"
#include "portable/distance.h"
#include "portable/fate.h"
#include "portable/geometry.h"
#include "portable/window.h"

layout(local_size_x_id = 0) in;

#ifdef ENTRY_admit
layout(push_constant) uniform Arguments { u32 first_item; Geometry g; u32 pass; u32 draws;
                                          u32 chunk; };
layout(binding = 0) readonly restrict buffer ColumnBegins { u32 column_begins[]; };
layout(binding = 1) readonly restrict buffer Candidates { uvec4 candidates[]; };
layout(binding = 2) coherent restrict buffer Fates { u32 fates[]; };
layout(binding = 3) coherent restrict buffer Undecided { u32 undecided[]; };
layout(binding = 4) writeonly restrict buffer Samples { uvec2 samples[]; };

// The first of [begin, end) whose y is at least low.
u32 lower_bound(u32 begin, u32 end, const u32 low) {
    while (begin < end) {
        const u32 middle = begin + (end - begin) / 2u;
        if (candidates[middle].y < low)
            begin = middle + 1u;
        else
            end = middle;
    }
    return begin;
}

// What can be said of a candidate now. Invocations of one pass read each other's fates while they
// are decided; whatever they see, a fate once decided is the right one.
u32 decide(const uvec4 candidate) {
    const u32 centre = candidate.z * g.strip_width + g.strip_width / 2u;
    const u32 column = column_of_line(candidate.z, g.lines, g.columns);
    const u32 first = first_neighbour(column, g.columns, g.period_x);
    const u32 count = neighbour_count(column, g.columns, g.period_x);
    const u32 windows = g.period_y != 0u ? 3u : 1u;

    // Look at all earlier candidates within reach.
    bool waits = false;
    for (u32 k = 0u; k < count; ++k) {
        const u32 neighbour = (first + k) % g.columns;
        const u32 end = column_begins[neighbour + 1u];
        for (u32 window = 0u; window < windows; ++window) {
            const u32 low = window_low(window, candidate.y, g.radius, g.height);
            const u32 high = window_high(window, candidate.y, g.radius, g.height);
            u32 j = low > high ? end : lower_bound(column_begins[neighbour], end, low);
            for (; j < end; ++j) {
                const uvec4 other = candidates[j];
                if (other.y > high) break;
                if (other.w >= candidate.w) continue;
                if (!conflicts(other.x, other.y, centre, candidate.y, g.period_x, g.period_y,
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
    const u32 end = min(begin + chunk, draws);
    for (u32 i = begin; i < end; ++i) {
        if (pass > 0u && atomicOr(fates[i], 0u) != FATE_UNDECIDED) continue;
        const uvec4 candidate = candidates[i];
        const u32 fate = decide(candidate);
        if (fate == FATE_UNDECIDED) {
            atomicAdd(undecided[pass], 1u);
            continue;
        }
        atomicExchange(fates[i], fate);
        samples[candidate.w] = fate == FATE_ADMITTED ? uvec2(candidate.x, candidate.y)
                                                     : uvec2(NO_SAMPLE, NO_SAMPLE);
    }
}
#endif
