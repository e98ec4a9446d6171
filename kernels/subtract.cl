// subtract: the chords of the round's samples, cut from the free spans of every line.
#include "portable/chord.h"
#include "portable/column.h"
#include "portable/distance.h"
#include "portable/failure.h"
#include "portable/fate.h"
#include "portable/geometry.h"

// Lists the samples that may cut a column's lines, in the order of y: a merge of up to three
// columns. near holds them from near_begins[column] on, near_counts[column] of them. Does nothing
// while admission is unsettled (undecided[last_pass] != 0).
kernel void gather(const Geometry g, const u32 last_pass, global const u32* restrict undecided,
                   global const u32* restrict column_begins,
                   global const u32* restrict near_begins,
                   global const uint4* restrict candidates, global const u32* restrict fates,
                   global u32* restrict near_counts, global uint2* restrict near,
                   volatile global u32* failure) {
    const u32 column = (u32)get_global_id(0);
    if (column >= g.columns || undecided[last_pass] != 0u) return;
    const u32 first = first_neighbour(column, g.columns, g.period_x);
    const u32 count = neighbour_count(column, g.columns, g.period_x);
    const u32 a = first;
    const u32 b = (first + 1u) % g.columns;
    const u32 c = (first + 2u) % g.columns;
    u32 i = column_begins[a];
    u32 j = column_begins[b];
    u32 k = column_begins[c];
    const u32 i_end = column_begins[a + 1u];
    const u32 j_end = count > 1u ? column_begins[b + 1u] : j;
    const u32 k_end = count > 2u ? column_begins[c + 1u] : k;

    u32 next = near_begins[column];
    while (true) {
        // Skip what is no sample.
        while (i < i_end && fates[i] != FATE_ADMITTED) ++i;
        while (j < j_end && fates[j] != FATE_ADMITTED) ++j;
        while (k < k_end && fates[k] != FATE_ADMITTED) ++k;

        // Take the lowest y; at equal y the first column's.
        const u32 y_i = i < i_end ? candidates[i].y : NO_SAMPLE;
        const u32 y_j = j < j_end ? candidates[j].y : NO_SAMPLE;
        const u32 y_k = k < k_end ? candidates[k].y : NO_SAMPLE;
        const u32 lowest = min(y_i, min(y_j, y_k));
        if (lowest == NO_SAMPLE) break;
        const u32 taken = y_i == lowest ? i : y_j == lowest ? j : k;
        if (y_i == lowest)
            ++i;
        else if (y_j == lowest)
            ++j;
        else
            ++k;
        near[next] = (uint2)(candidates[taken].x, lowest);
        ++next;
    }
    near_counts[column] = next - near_begins[column];
    if (!has_turns_left(g.height)) atomic_or(failure, FAILED_GATHER);
}

// A line's spans with a gap that moves along: [0, done) lie below it, [rest, end) above. Chords
// that come in the order of y move it a little at a time, and cut where it stands. It opens when a
// chord first leaves more pieces than before. The spans beside it are at hand: `below` is a copy of
// the last one below it, or empty at 0, `above` of the first one above it, or beyond every y.
typedef struct Gap {
    u32 done;
    u32 rest;
    u32 end;
    u32 room;    // where the end may move to
    u32 total;   // length of all spans
    uint2 below;
    uint2 above;
} Gap;

void load_below(global uint2* spans, Gap* gap) {
    gap->below = gap->done > 0u ? spans[gap->done - 1u] : (uint2)(0u, 0u);
}

void load_above(global uint2* spans, Gap* gap) {
    gap->above = gap->rest < gap->end ? spans[gap->rest] : (uint2)(NO_SAMPLE, NO_SAMPLE);
}

// Moves what lies above the gap to the end of the room. False when it is there already.
bool open_gap(global uint2* spans, Gap* gap) {
    const u32 shift = gap->room - gap->end;
    for (u32 i = gap->end; i > gap->rest; --i) spans[i - 1u + shift] = spans[i - 1u];
    gap->rest += shift;
    gap->end += shift;
    return shift > 0u;
}

// Takes [begin, end) out. False when the room is used up: then nothing is cut.
bool cut_out(global uint2* spans, Gap* gap, const u32 begin, const u32 end) {
    // Move the gap down, or up, to where the chord begins.
    while (gap->below.y > begin) {
        --gap->rest;
        --gap->done;
        gap->above = gap->below;
        if (gap->done < gap->rest) spans[gap->rest] = gap->above;
        load_below(spans, gap);
    }
    while (gap->above.y <= begin) {
        gap->below = gap->above;
        if (gap->done < gap->rest) spans[gap->done] = gap->below;
        ++gap->done;
        ++gap->rest;
        load_above(spans, gap);
    }

    // Keep what the chord leaves of its first span below it.
    if (gap->above.x < begin) {
        const bool is_inside = gap->above.y > end;  // one piece more than before
        if (is_inside && gap->done == gap->rest && !open_gap(spans, gap)) return false;
        gap->total -= (is_inside ? end : gap->above.y) - begin;
        gap->below = (uint2)(gap->above.x, begin);
        if (is_inside) {
            gap->above.x = end;
            spans[gap->rest] = gap->above;
        } else {
            ++gap->rest;
            load_above(spans, gap);
        }
        spans[gap->done] = gap->below;
        ++gap->done;
    }

    // Drop what it covers, and keep what it leaves of its last span above it.
    while (gap->above.y <= end) {
        gap->total -= gap->above.y - gap->above.x;
        ++gap->rest;
        load_above(spans, gap);
    }
    if (gap->above.x < end) {
        gap->total -= end - gap->above.x;
        gap->above.x = end;
        spans[gap->rest] = gap->above;
    }
    return true;
}

// In exact a chord is what covers the strip's whole width: it is cut at the far edge.
u32 reach_of(const Geometry g, const u32 centre, const uint2 sample) {
    return chord_reach(axis_distance(sample.x, centre, g.period_x) + g.chord_margin,
                       g.radius_squared);
}

// Serves the lines [first_line, end_line), which `spans` holds from its begin on. A line that runs
// out of room raises *overflow and keeps what it has, less some cuts: cutting again, with more
// room, completes it.
kernel void subtract(const Geometry g, const u32 first_line, const u32 end_line,
                     const u32 last_pass, global const u32* restrict undecided,
                     global const u32* restrict near_begins,
                     global const u32* restrict near_counts, global const uint2* restrict near,
                     global uint2* spans, global u32* restrict span_counts,
                     global u32* restrict free_lengths, volatile global u32* overflow,
                     volatile global u32* failure) {
    const u32 line = first_line + (u32)get_global_id(0);
    if (line >= end_line || undecided[last_pass] != 0u) return;
    const u32 column = column_of_line(line, g.lines, g.columns);
    const u32 near_begin = near_begins[column];
    const u32 near_end = near_begin + near_counts[column];
    const u32 count = span_counts[line];
    if (near_begin == near_end || count == 0u) return;

    const u32 centre = line * g.strip_width + g.strip_width / 2u;
    global uint2* slot = spans + (u64)(line - first_line) * g.capacity;
    const u32 room = min(g.capacity, count + (near_end - near_begin) + 2u);
    Gap gap = {0u, 0u, count, room, free_lengths[line], (uint2)(0u, 0u), slot[0]};
    bool fits = true;

    // On a torus, what sticks out at one end is cut at the other.
    u32 bottom = 0u;
    u32 top = g.height;
    if (g.period_y != 0u) {
        for (u32 i = near_end; i > near_begin; --i) {
            const uint2 sample = near[i - 1u];
            if (g.height - sample.y > g.radius) break;
            bottom =
                max(bottom, chord_wrapped_end(sample.y, reach_of(g, centre, sample), g.height));
        }
        for (u32 i = near_begin; i < near_end; ++i) {
            const uint2 sample = near[i];
            if (sample.y >= g.radius) break;
            top = min(top, chord_wrapped_begin(sample.y, reach_of(g, centre, sample), g.height));
        }
    }

    // Cut the chords from the bottom up.
    if (bottom > 0u) fits = cut_out(slot, &gap, 0u, bottom);
    for (u32 i = near_begin; i < near_end && fits; ++i) {
        const uint2 sample = near[i];
        const u32 reach = reach_of(g, centre, sample);
        if (reach == 0u) continue;
        fits = cut_out(slot, &gap, chord_begin(sample.y, reach),
                   chord_end(sample.y, reach, g.height));
    }
    if (top < g.height && fits) fits = cut_out(slot, &gap, top, g.height);
    if (!fits) atomic_xchg(overflow, 1u);

    // Close the gap.
    if (gap.done == gap.rest) gap.done = gap.rest = gap.end;
    while (gap.rest < gap.end) {
        slot[gap.done] = slot[gap.rest];
        ++gap.done;
        ++gap.rest;
    }
    span_counts[line] = gap.done;
    free_lengths[line] = gap.total;
    if (!has_turns_left(g.height)) atomic_or(failure, FAILED_SUBTRACT);
}

// Moves the lines [first_line, end_line) from slots of g.capacity spans to slots of `larger`.
// `from` holds the lines from from_line on, `to` those from to_line on.
kernel void grow(const Geometry g, const u32 from_line, const u32 to_line, const u32 first_line,
                 const u32 end_line, const u32 larger, global const u32* restrict span_counts,
                 global const uint2* restrict from, global uint2* restrict to) {
    const u32 line = first_line + (u32)get_global_id(0);
    if (line >= end_line) return;
    const u64 from_begin = (u64)(line - from_line) * g.capacity;
    const u64 to_begin = (u64)(line - to_line) * larger;
    const u32 count = span_counts[line];
    for (u32 i = 0u; i < count; ++i) to[to_begin + i] = from[from_begin + i];
}
