// subtract in mode cells: the lattice points that the round's samples block, taken out of every
// line by the two-way check of section 4.2, a pixel's run of points at a time.
#include "portable/bits.h"
#include "portable/chord.h"
#include "portable/column.h"
#include "portable/distance.h"
#include "portable/failure.h"
#include "portable/fate.h"
#include "portable/geometry.h"
#include "portable/metric.h"

// One sample on one line.
typedef struct Cut {
    u32 metric;
    u32 radius;
    u32 dx;
    u32 word;     // of the line, its bits from here on
    u32 mask;     // what is to be cleared of it
    u32 blocked;  // points
} Cut;

// Items may clear one word at a time: what was still set tells each what it has blocked.
void clear_word(volatile global u32* bits, Cut* cut) {
    if (cut->mask == 0u) return;
    cut->blocked += count_bits(atomic_and(&bits[cut->word], ~cut->mask) & cut->mask);
    cut->mask = 0u;
}

// Clears [begin, end), the last word of it with what comes next.
void clear_run(const u32 line_begin, const u32 begin, const u32 end, volatile global u32* bits,
               Cut* cut) {
    for (u32 word = begin / 32u; word <= (end - 1u) / 32u; ++word) {
        if (line_begin + word != cut->word) {
            clear_word(bits, cut);
            cut->word = line_begin + word;
        }
        cut->mask |= word_mask(word, begin, end);
    }
}

// Whether the point dy above or below the sample is blocked, where pixels have this limit.
bool is_blocked(const u32 dx, const int dy, const u64 limit) {
    const u64 across = dx;
    const u64 up = (u64)(long)dy;
    return across * across + up * up < limit;
}

// What the metric of the sample, seen at height y, and a pixel takes of [begin, end), above which
// lies that pixel alone. Mostly all or nothing, which squared distances tell without a root.
int2 blocked_of_run(const u32 pixel, const int y, const int begin, const int end, const Cut* cut) {
    if (pixel == 0u) return (int2)(begin, end);  // no importance: never set
    const u64 limit = metric_squared(twice_metric_radius(cut->metric, cut->radius, pixel));
    const int below = y - begin;    // of the run's first point
    const int above = end - 1 - y;  // of its last
    if (is_blocked(cut->dx, max(below, above), limit)) return (int2)(begin, end);
    const int nearest = max(max(-below, -above), 0);
    if (!is_blocked(cut->dx, nearest, limit)) return (int2)(end, end);
    const int reach = (int)chord_reach(cut->dx, limit);
    return (int2)(max(begin, y - reach + 1), min(end, y + reach));
}

// Blocks what the sample, seen at height y, takes of the `chord` points to either side.
void block(const Geometry g, const u32 line_begin, const u32 pixel_begin, const int y,
           const int chord, global const u32* restrict row_of,
           global const u32* restrict row_begins, global const u32* restrict pixel_radii,
           volatile global u32* bits, Cut* cut) {
    int begin = max(y - chord + 1, 0);
    const int end = min(y + chord, (int)g.height);
    int from = begin;  // [from, begin) is blocked, but not yet cleared
    while (begin < end) {
        const u32 row = row_of[begin];
        const int run_end = min(end, (int)row_begins[row + 1u]);
        const int2 run = blocked_of_run(pixel_radii[pixel_begin + row], y, begin, run_end, cut);
        if (run.x != begin) {
            if (from < begin) clear_run(line_begin, (u32)from, (u32)begin, bits, cut);
            from = run.x;
        }
        if (run.y != run_end) {
            if (from < run.y) clear_run(line_begin, (u32)from, (u32)run.y, bits, cut);
            from = run_end;
        }
        begin = run_end;
    }
    if (from < end) clear_run(line_begin, (u32)from, (u32)end, bits, cut);
}

// Whether a point of [begin, end) may be free: of few or many words, some may.
bool any_set(const u32 line_begin, const u32 begin, const u32 end, volatile global u32* bits) {
    if (end - begin > MOST_LOOKS * 32u) return true;
    for (u32 word = begin / 32u; word * 32u < end; ++word)
        if ((atomic_or(&bits[line_begin + word], 0u) & word_mask(word, begin, end)) != 0u)
            return true;
    return false;
}

// How far from the sample's height a free point of the line can be that it blocks, plus 1; 0 if
// none. With min no farther than its radius. With mean and max the widest pixels reach farthest,
// and they are the first to be blocked. Items look side by side: wherever widest[line] stands, no
// wider row has a free point.
int half_chord(const Cut* cut, const u32 reach, const u32 line, const u32 line_begin,
               const u32 pixel_begin, const u32 rows, global const u32* restrict row_begins,
               global const u32* restrict pixel_radii, global const u32* restrict widest_rows,
               volatile global u32* bits, volatile global u32* widest) {
    u64 limit = reach;
    limit = limit * limit + 1u;
    u64 dx_squared = cut->dx;
    dx_squared = dx_squared * dx_squared;
    if (dx_squared >= limit) return 0;
    if (!is_far_reach(cut->metric, reach, cut->radius)) return (int)chord_reach(cut->dx, limit);

    // Pass over pixels without a free point until one has some, or all that are left are too small.
    const u32 first = atomic_or(&widest[line], 0u);
    u32 i = first;
    for (u32 looks = 0u; i < rows && looks < MOST_LOOKS; ++i) {
        const u32 row = widest_rows[pixel_begin + i];
        const u32 bound = class_bound(pixel_radii[pixel_begin + row]);
        limit = min(limit, metric_squared(twice_metric_radius(cut->metric, cut->radius, bound)));
        const u32 begin = row_begins[row];
        const u32 end = row_begins[row + 1u];
        if (dx_squared >= limit || any_set(line_begin, begin, end, bits)) break;
        looks += (end - begin) / 32u + 1u;
    }
    if (i > first) atomic_max(&widest[line], i);
    return i == rows ? 0 : (int)chord_reach(cut->dx, limit);
}

// A work item serves one of so many `slices` of the lines near each sample of its chunk of
// candidates: every slices-th line. Does nothing while admission is unsettled
// (undecided[last_pass] != 0).
kernel void subtract_in_cells(const Geometry g, const u32 words, const u32 rows, const u32 metric,
                              const u32 last_pass, const u32 draw_count, const u32 chunk,
                              const u32 slices, global const u32* restrict undecided,
                              global const uint4* restrict candidates,
                              global const u32* restrict candidate_radii,
                              global const u32* restrict fates,
                              global const u32* restrict column_of,
                              global const u32* restrict row_of,
                              global const u32* restrict row_begins,
                              global const u32* restrict pixel_radii,
                              global const u32* restrict pixel_reaches,
                              global const u32* restrict widest_rows, volatile global u32* widest,
                              volatile global u32* bits, volatile global u32* free_lengths,
                              volatile global u32* failure) {
    if (undecided[last_pass] != 0u) return;
    const u32 item = (u32)get_global_id(0);
    const u32 begin = item / slices * chunk;
    const u32 end = min(begin + chunk, draw_count);
    for (u32 i = begin; i < end; ++i) {
        if (fates[i] != FATE_ADMITTED) continue;
        const uint4 sample = candidates[i];
        const u32 reach = pixel_reaches[column_of[sample.x] * rows + row_of[sample.y]];
        const Stretch near = near_lines(sample.x, reach, g.lines, g.period_x);
        for (u32 k = item % slices; k < near.count; k += slices) {
            const u32 line = (near.first + k) % g.lines;
            Cut cut = {metric, candidate_radii[i], axis_distance(sample.x, line, g.period_x),
                       0u, 0u, 0u};
            const u32 pixel_begin = column_of[line] * rows;
            const int chord = half_chord(&cut, reach, line, line * words, pixel_begin, rows,
                                         row_begins, pixel_radii, widest_rows, bits, widest);
            const int y = (int)sample.y;
            const int period = (int)g.period_y;
            for (int shift = -period; shift <= period; shift += max(period, 1))
                block(g, line * words, pixel_begin, y + shift, chord, row_of, row_begins,
                      pixel_radii, bits, &cut);
            clear_word(bits, &cut);
            if (cut.blocked != 0u) atomic_sub(&free_lengths[line], cut.blocked);
        }
    }
    if (!has_turns_left(g.height)) atomic_or(failure, FAILED_SUBTRACT);
}
