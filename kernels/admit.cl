// admit: a candidate becomes a sample unless an earlier sample covers it. Earlier is by the order
// of the draws, whatever the order of the work.
#include "lower_bound.h"
#include "portable/sample_grid.h"
#include "portable/column.h"
#include "portable/distance.h"
#include "portable/failure.h"
#include "portable/fate.h"
#include "portable/geometry.h"
#include "portable/window.h"

// Whether a sample of an earlier round is closer than the radius.
bool is_covered(const Geometry g, const u32 x, const u32 y, global const u32* restrict grid_x,
                global const u32* restrict grid_y) {
    const u32 x_windows = g.period_x != 0u ? 3u : 1u;
    const u32 y_windows = g.period_y != 0u ? 3u : 1u;
    for (u32 i = 0u; i < x_windows; ++i) {
        const u32 column_low = near_low(i, x, x + 1u, g.radius, g.width, g.grid_side);
        const u32 column_high = near_high(i, x, x + 1u, g.radius, g.width, g.grid_side);
        for (u32 j = 0u; j < y_windows; ++j) {
            const u32 row_low = near_low(j, y, y + 1u, g.radius, g.height, g.grid_side);
            const u32 row_high = near_high(j, y, y + 1u, g.radius, g.height, g.grid_side);
            for (u32 column = column_low; column <= column_high; ++column) {
                for (u32 row = row_low; row <= row_high; ++row) {
                    const u32 cell = column * g.grid_rows + row;
                    if (grid_x[cell] != NO_SAMPLE &&
                        conflicts(grid_x[cell], grid_y[cell], x, y, g.period_x, g.period_y,
                                  g.radius_squared))
                        return true;
                }
            }
        }
    }
    return false;
}

// The same where the disk touches no edge: it lies within 4 x 4 cells, 2 sqrt(2) being less than 3.
// No branch: where a sample lies cannot be foretold. A cell without one is masked, since the square
// of its coordinates overflows.
bool is_covered_inside(const Geometry g, const u32 x, const u32 y,
                       global const u32* restrict grid_x, global const u32* restrict grid_y) {
    const u32 column = min((x - g.radius) / g.grid_side, g.grid_columns - 4u);
    const u32 row = min((y - g.radius) / g.grid_side, g.grid_rows - 4u);
    bool covered = false;
    for (u32 i = 0u; i < 4u; ++i) {
        const u32 first = (column + i) * g.grid_rows + row;
        for (u32 j = 0u; j < 4u; ++j) {
            const u32 sample_x = grid_x[first + j];
            const u32 sample_y = grid_y[first + j];
            const bool is_near =
                squared_length(axis_distance(sample_x, x, 0u), axis_distance(sample_y, y, 0u)) <
                g.radius_squared;
            covered = covered | (is_near & (sample_x != NO_SAMPLE));
        }
    }
    return covered;
}

// In exact: settles the candidates that samples of earlier rounds cover. Each chunk of draws lists
// its others in `pending`, then NO_SAMPLE. samples[order] is where the host looks for what became
// of that draw.
kernel void screen(const Geometry g, const u32 draw_count, const u32 chunk,
                   global const uint4* restrict candidates, global const u32* restrict grid_x,
                   global const u32* restrict grid_y, global u32* restrict fates,
                   global u32* restrict pending, global uint2* restrict samples) {
    const bool has_inside = g.grid_columns >= 4u && g.grid_rows >= 4u && g.radius < g.width &&
                            g.radius < g.height;
    const u32 begin = (u32)get_global_id(0) * chunk;
    const u32 end = min(begin + chunk, draw_count);
    u32 left = begin;
    for (u32 i = begin; i < end; ++i) {
        if (fates[i] != FATE_UNDECIDED) continue;
        const uint4 candidate = candidates[i];
        const bool is_inside = has_inside && candidate.x >= g.radius && candidate.y >= g.radius &&
                               candidate.x < g.width - g.radius &&
                               candidate.y < g.height - g.radius;
        if (is_inside ? is_covered_inside(g, candidate.x, candidate.y, grid_x, grid_y)
                      : is_covered(g, candidate.x, candidate.y, grid_x, grid_y)) {
            fates[i] = FATE_COVERED;
            samples[candidate.w] = (uint2)(NO_SAMPLE, FATE_COVERED);
        } else {
            pending[left] = i;
            ++left;
        }
    }
    if (left < end) pending[left] = NO_SAMPLE;
}

// A column and its neighbours. hints[k] is the first candidate of one that is not below the reach
// of the last y; they ascend with y.
typedef struct Reach {
    u32 count;
    u32 begins[3];
    u32 ends[3];
    u32 hints[3];
} Reach;

void enter(const Geometry g, const u32 column, const u32 low,
           global const u32* restrict column_begins, global const uint4* restrict candidates,
           Reach* reach) {
    const u32 first = first_neighbour(column, g.columns, g.period_x);
    reach->count = neighbour_count(column, g.columns, g.period_x);
    for (u32 k = 0u; k < reach->count; ++k) {
        const u32 neighbour = (first + k) % g.columns;
        reach->begins[k] = column_begins[neighbour];
        reach->ends[k] = column_begins[neighbour + 1u];
        reach->hints[k] = lower_bound(candidates, reach->begins[k], reach->ends[k], low);
    }
}

// What can be said of a candidate now. Items of one pass read each other's fates while they are
// decided; whatever they see, a fate once decided is the right one.
u32 decide(const Geometry g, const uint4 candidate, global const uint4* restrict candidates,
           volatile global u32* fates, Reach* reach) {
    // On a line, what counts is the chord on that line.
    const u32 x = g.is_exact != 0u ? candidate.x
                                   : candidate.z * g.strip_width + g.strip_width / 2u;
    const bool is_at_edge = candidate.y < g.radius || candidate.y + g.radius >= g.height;
    const u32 windows = g.period_y != 0u && is_at_edge ? 3u : 1u;

    // Look at all earlier candidates within reach.
    bool waits = false;
    for (u32 k = 0u; k < reach->count; ++k) {
        const u32 end = reach->ends[k];
        for (u32 window = 0u; window < windows; ++window) {
            const u32 low = window_low(window, candidate.y, g.radius, g.height);
            const u32 high = window_high(window, candidate.y, g.radius, g.height);
            if (low > high) continue;
            u32 j = reach->hints[k];
            if (window == 0u) {
                while (j < end && candidates[j].y < low) ++j;
                reach->hints[k] = j;
            } else {
                j = lower_bound(candidates, reach->begins[k], end, low);
            }
            for (; j < end; ++j) {
                const uint4 other = candidates[j];
                if (other.y > high) break;
                if (other.w >= candidate.w) continue;
                if (!conflicts(other.x, other.y, x, candidate.y, g.period_x, g.period_y,
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

// One pass over all candidates that are pending, which each chunk lists from its begin on, up to
// NO_SAMPLE. undecided[pass] counts those it leaves; a pass after one that left none has nothing to
// do.
kernel void admit(const Geometry g, const u32 pass, const u32 draw_count, const u32 chunk,
                  global const u32* restrict column_begins,
                  global const uint4* restrict candidates, volatile global u32* fates,
                  global u32* restrict pending, volatile global u32* undecided,
                  global uint2* restrict samples, volatile global u32* failure) {
    if (pass > 0u && undecided[pass - 1u] == 0u) return;
    const u32 begin = (u32)get_global_id(0) * chunk;
    const u32 end = min(begin + chunk, draw_count);
    Reach reach;
    u32 column_end = 0u;
    u32 left = begin;
    for (u32 next = begin; next < end; ++next) {
        const u32 i = pending[next];
        if (i == NO_SAMPLE) break;
        const uint4 candidate = candidates[i];
        if (i >= column_end) {
            const u32 column = column_of_line(candidate.z, g.lines, g.columns);
            column_end = column_begins[column + 1u];
            enter(g, column, window_low(0u, candidate.y, g.radius, g.height), column_begins,
                  candidates, &reach);
        }
        const u32 fate = decide(g, candidate, candidates, fates, &reach);
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
