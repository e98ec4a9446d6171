// admit in mode cells: a candidate becomes a sample unless an earlier sample of the round is closer
// than the metric of their radii allows. See admit.cl for the order of the work.
#include "lower_bound.h"
#include "portable/column.h"
#include "portable/distance.h"
#include "portable/failure.h"
#include "portable/fate.h"
#include "portable/geometry.h"
#include "portable/metric.h"
#include "portable/window.h"

// What can be said of a candidate now, whose conflicts are all within `reach` lattice steps. Items
// of one pass read each other's fates while they are decided; whatever they see, a fate once
// decided is the right one.
u32 decide(const Geometry g, const u32 metric, const uint4 candidate, const u32 radius,
           const u32 reach, global const u32* restrict column_begins,
           global const uint4* restrict candidates, global const u32* restrict candidate_radii,
           volatile global u32* fates) {
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
            if (low > high) continue;
            for (u32 j = lower_bound(candidates, begin, end, low); j < end; ++j) {
                const uint4 other = candidates[j];
                if (other.y > high) break;
                if (other.w >= candidate.w) continue;
                const u32 twice = twice_metric_radius(metric, radius, candidate_radii[j]);
                if (!conflicts(other.x, other.y, candidate.x, candidate.y, g.period_x, g.period_y,
                               metric_squared(twice)))
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

// One pass over all candidates that are pending, which each chunk lists from its begin on, up to
// NO_SAMPLE. undecided[pass] counts those it leaves; a pass after one that left none has nothing to
// do. samples[order] is where the host looks for what became of that draw.
kernel void admit_in_cells(const Geometry g, const u32 rows, const u32 metric, const u32 pass,
                           const u32 draw_count, const u32 chunk,
                           global const u32* restrict column_begins,
                           global const uint4* restrict candidates,
                           global const u32* restrict candidate_radii,
                           global const u32* restrict column_of, global const u32* restrict row_of,
                           global const u32* restrict pixel_reaches, volatile global u32* fates,
                           global u32* restrict pending, volatile global u32* undecided,
                           global uint2* restrict samples, volatile global u32* failure) {
    if (pass > 0u && undecided[pass - 1u] == 0u) return;
    const u32 begin = (u32)get_global_id(0) * chunk;
    const u32 end = min(begin + chunk, draw_count);
    u32 left = begin;
    for (u32 next = begin; next < end; ++next) {
        const u32 i = pending[next];
        if (i == NO_SAMPLE) break;
        const uint4 candidate = candidates[i];
        const u32 reach = pixel_reaches[column_of[candidate.x] * rows + row_of[candidate.y]];
        const u32 fate = decide(g, metric, candidate, candidate_radii[i], reach, column_begins,
                                candidates, candidate_radii, fates);
        if (fate == FATE_UNDECIDED) {
            pending[left] = i;
            ++left;
            continue;
        }
        atomic_xchg(&fates[i], fate);
        samples[candidate.w] = fate == FATE_ADMITTED ? (uint2)(candidate.x, candidate.y)
                                                     : (uint2)(NO_SAMPLE, fate);
    }
    if (left < end) pending[left] = NO_SAMPLE;
    if (left > begin) atomic_add(&undecided[pass], left - begin);
    if (!has_turns_left(g.height)) atomic_or(failure, FAILED_ADMIT);
}
