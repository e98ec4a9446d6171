// admit: a candidate becomes a sample unless an earlier sample of the round covers it. Earlier is
// by the order of the draws, whatever the order of the work.
#include "portable/column.h"
#include "portable/distance.h"
#include "portable/fate.h"
#include "portable/geometry.h"
#include "portable/window.h"

// The first of [begin, end) whose y is at least low.
u32 lower_bound(global const uint4* restrict candidates, u32 begin, u32 end, const u32 low) {
    while (begin < end) {
        const u32 middle = begin + (end - begin) / 2u;
        if (candidates[middle].y < low)
            begin = middle + 1u;
        else
            end = middle;
    }
    return begin;
}

// What can be said of a candidate now. Items of one pass read each other's fates while they are
// decided; whatever they see, a fate once decided is the right one.
u32 decide(const Geometry g, const uint4 candidate, global const u32* restrict column_begins,
           global const uint4* restrict candidates, volatile global u32* fates) {
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
            u32 j = low > high ? end
                               : lower_bound(candidates, column_begins[neighbour], end, low);
            for (; j < end; ++j) {
                const uint4 other = candidates[j];
                if (other.y > high) break;
                if (other.w >= candidate.w) continue;
                if (!conflicts(other.x, other.y, centre, candidate.y, g.period_x, g.period_y,
                               g.radius_squared))
                    continue;
                // A sample covers this candidate for good; an undecided one may yet.
                const u32 fate = atomic_or(&fates[j], 0u);
                if (fate == FATE_ADMITTED) return FATE_REJECTED;
                waits = waits || fate == FATE_UNDECIDED;
            }
        }
    }
    return waits ? FATE_UNDECIDED : FATE_ADMITTED;
}

// One pass over all candidates. undecided[pass] counts those it leaves; a pass after one that left
// none has nothing to do. samples[order] is where the host looks for the sample of that draw.
kernel void admit(const Geometry g, const u32 pass, const u32 draws, const u32 chunk,
                  global const u32* restrict column_begins,
                  global const uint4* restrict candidates, volatile global u32* fates,
                  volatile global u32* undecided, global uint2* restrict samples) {
    if (pass > 0u && undecided[pass - 1u] == 0u) return;
    const u32 begin = (u32)get_global_id(0) * chunk;
    const u32 end = min(begin + chunk, draws);
    for (u32 i = begin; i < end; ++i) {
        if (pass > 0u && atomic_or(&fates[i], 0u) != FATE_UNDECIDED) continue;
        const uint4 candidate = candidates[i];
        const u32 fate = decide(g, candidate, column_begins, candidates, fates);
        if (fate == FATE_UNDECIDED) {
            atomic_inc(&undecided[pass]);
            continue;
        }
        atomic_xchg(&fates[i], fate);
        samples[candidate.w] = fate == FATE_ADMITTED ? (uint2)(candidate.x, candidate.y)
                                                     : (uint2)(NO_SAMPLE, NO_SAMPLE);
    }
}
