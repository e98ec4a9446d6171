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
                              global const u32* restrict pixel_reaches, volatile global u32* bits,
                              volatile global u32* free_lengths, volatile global u32* failure) {
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
            const u64 widest = reach;
            const int chord = (int)chord_reach(cut.dx, widest * widest + 1u);
            const int y = (int)sample.y;
            const int period = (int)g.period_y;
            const u32 pixel_begin = column_of[line] * rows;
            for (int shift = -period; shift <= period; shift += max(period, 1))
                block(g, line * words, pixel_begin, y + shift, chord, row_of, row_begins,
                      pixel_radii, bits, &cut);
            clear_word(bits, &cut);
            if (cut.blocked != 0u) atomic_sub(&free_lengths[line], cut.blocked);
        }
    }
    if (!has_turns_left(g.height)) atomic_or(failure, FAILED_SUBTRACT);
}
