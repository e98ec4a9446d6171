// subtract: the chords of the round's samples, cut from the free spans of every line.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#include "portable/chord.h"
#include "portable/column.h"
#include "portable/distance.h"
#include "portable/failure.h"
#include "portable/fate.h"
#include "portable/geometry.h"

layout(local_size_x_id = 0) in;

#ifdef ENTRY_gather
// Lists the samples that may cut a column's lines, in the order of y: a merge of up to three
// columns. near holds them from near_begins[column] on, near_counts[column] of them. Does nothing
// while admission is unsettled (undecided[last_pass] != 0).
layout(push_constant) uniform Arguments { u32 first_item; Geometry g; u32 last_pass; };
layout(binding = 0) readonly restrict buffer Undecided { u32 undecided[]; };
layout(binding = 1) readonly restrict buffer ColumnBegins { u32 column_begins[]; };
layout(binding = 2) readonly restrict buffer NearBegins { u32 near_begins[]; };
layout(binding = 3) readonly restrict buffer Candidates { uvec4 candidates[]; };
layout(binding = 4) readonly restrict buffer Fates { u32 fates[]; };
layout(binding = 5) writeonly restrict buffer NearCounts { u32 near_counts[]; };
layout(binding = 6) writeonly restrict buffer Near { uvec2 near[]; };
layout(binding = 7) coherent restrict buffer Failure { u32 failure; };

void main() {
    const u32 column = first_item + gl_GlobalInvocationID.x;
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
        near[next] = uvec2(candidates[taken].x, lowest);
        ++next;
    }
    near_counts[column] = next - near_begins[column];
    if (!has_turns_left(g.height)) atomicOr(failure, FAILED_GATHER);
}
#endif

#ifdef ENTRY_subtract
// Serves the lines [first_line, end_line), which `spans` holds from its begin on. A line that runs
// out of room raises overflow and keeps what it has, less some cuts: cutting again, with more
// room, completes it.
layout(push_constant) uniform Arguments { u32 first_item; Geometry g; u32 first_line;
                                          u32 end_line; u32 last_pass; };
layout(binding = 0) readonly restrict buffer Undecided { u32 undecided[]; };
layout(binding = 1) readonly restrict buffer NearBegins { u32 near_begins[]; };
layout(binding = 2) readonly restrict buffer NearCounts { u32 near_counts[]; };
layout(binding = 3) readonly restrict buffer Near { uvec2 near[]; };
layout(binding = 4) restrict buffer Spans { uvec2 spans[]; };
layout(binding = 5) restrict buffer SpanCounts { u32 span_counts[]; };
layout(binding = 6) restrict buffer FreeLengths { u32 free_lengths[]; };
layout(binding = 7) coherent restrict buffer Overflow { u32 overflow; };
layout(binding = 8) coherent restrict buffer Failure { u32 failure; };

// A line's spans with a gap that moves along: [slot, done) lie below it, [rest, end) above. Chords
// that come in the order of y move it a little at a time, and cut where it stands. It opens when a
// chord first leaves more pieces than before. The spans beside it are at hand: `below` is a copy of
// the last one below it, or empty at 0, `above` of the first one above it, or beyond every y.
struct Gap {
    u32 slot;
    u32 done;
    u32 rest;
    u32 end;
    u32 room;    // where the end may move to
    u32 total;   // length of all spans
    uvec2 below;
    uvec2 above;
};

void load_below(inout Gap gap) {
    gap.below = gap.done > gap.slot ? spans[gap.done - 1u] : uvec2(0u, 0u);
}

void load_above(inout Gap gap) {
    gap.above = gap.rest < gap.end ? spans[gap.rest] : uvec2(NO_SAMPLE, NO_SAMPLE);
}

// Moves what lies above the gap to the end of the room. False when it is there already.
bool open_gap(inout Gap gap) {
    const u32 shift = gap.room - gap.end;
    for (u32 i = gap.end; i > gap.rest; --i) spans[i - 1u + shift] = spans[i - 1u];
    gap.rest += shift;
    gap.end += shift;
    return shift > 0u;
}

// Takes [begin, end) out. False when the room is used up: then nothing is cut.
bool cut(inout Gap gap, const u32 begin, const u32 end) {
    // Move the gap down, or up, to where the chord begins.
    while (gap.below.y > begin) {
        --gap.rest;
        --gap.done;
        gap.above = gap.below;
        if (gap.done < gap.rest) spans[gap.rest] = gap.above;
        load_below(gap);
    }
    while (gap.above.y <= begin) {
        gap.below = gap.above;
        if (gap.done < gap.rest) spans[gap.done] = gap.below;
        ++gap.done;
        ++gap.rest;
        load_above(gap);
    }

    // Keep what the chord leaves of its first span below it.
    if (gap.above.x < begin) {
        const bool is_inside = gap.above.y > end;  // one piece more than before
        if (is_inside && gap.done == gap.rest && !open_gap(gap)) return false;
        gap.total -= (is_inside ? end : gap.above.y) - begin;
        gap.below = uvec2(gap.above.x, begin);
        if (is_inside) {
            gap.above.x = end;
            spans[gap.rest] = gap.above;
        } else {
            ++gap.rest;
            load_above(gap);
        }
        spans[gap.done] = gap.below;
        ++gap.done;
    }

    // Drop what it covers, and keep what it leaves of its last span above it.
    while (gap.above.y <= end) {
        gap.total -= gap.above.y - gap.above.x;
        ++gap.rest;
        load_above(gap);
    }
    if (gap.above.x < end) {
        gap.total -= end - gap.above.x;
        gap.above.x = end;
        spans[gap.rest] = gap.above;
    }
    return true;
}

u32 reach_of(const u32 centre, const uvec2 a_sample) {
    const u32 dx = axis_distance(a_sample.x, centre, g.period_x) + g.chord_margin;
    return chord_reach(dx, g.radius_squared);
}

void main() {
    const u32 line = first_line + first_item + gl_GlobalInvocationID.x;
    if (line >= end_line || undecided[last_pass] != 0u) return;
    const u32 column = column_of_line(line, g.lines, g.columns);
    const u32 near_begin = near_begins[column];
    const u32 near_end = near_begin + near_counts[column];
    const u32 count = span_counts[line];
    if (near_begin == near_end || count == 0u) return;

    const u32 centre = line * g.strip_width + g.strip_width / 2u;
    const u32 slot = (line - first_line) * g.capacity;
    const u32 room = min(g.capacity, count + (near_end - near_begin) + 2u);
    Gap gap = {slot, slot, slot, slot + count, slot + room, free_lengths[line], uvec2(0u, 0u),
               spans[slot]};
    bool fits = true;

    // On a torus, what sticks out at one end is cut at the other.
    u32 bottom = 0u;
    u32 top = g.height;
    if (g.period_y != 0u) {
        for (u32 i = near_end; i > near_begin; --i) {
            const uvec2 s = near[i - 1u];
            if (g.height - s.y > g.radius) break;
            bottom = max(bottom, chord_wrapped_end(s.y, reach_of(centre, s), g.height));
        }
        for (u32 i = near_begin; i < near_end; ++i) {
            const uvec2 s = near[i];
            if (s.y >= g.radius) break;
            top = min(top, chord_wrapped_begin(s.y, reach_of(centre, s), g.height));
        }
    }

    // Cut the chords from the bottom up.
    if (bottom > 0u) fits = cut(gap, 0u, bottom);
    for (u32 i = near_begin; i < near_end && fits; ++i) {
        const uvec2 s = near[i];
        const u32 reach = reach_of(centre, s);
        if (reach == 0u) continue;
        fits = cut(gap, chord_begin(s.y, reach), chord_end(s.y, reach, g.height));
    }
    if (top < g.height && fits) fits = cut(gap, top, g.height);
    if (!fits) atomicExchange(overflow, 1u);

    // Close the gap.
    if (gap.done == gap.rest) gap.done = gap.rest = gap.end;
    while (gap.rest < gap.end) {
        spans[gap.done] = spans[gap.rest];
        ++gap.done;
        ++gap.rest;
    }
    span_counts[line] = gap.done - slot;
    free_lengths[line] = gap.total;
    if (!has_turns_left(g.height)) atomicOr(failure, FAILED_SUBTRACT);
}
#endif

#ifdef ENTRY_grow
// Moves the lines [first_line, end_line) from slots of g.capacity spans to slots of `larger`.
// `from` holds the lines from from_line on, `to` those from to_line on.
layout(push_constant) uniform Arguments { u32 first_item; Geometry g; u32 from_line; u32 to_line;
                                          u32 first_line; u32 end_line; u32 larger; };
layout(binding = 0) readonly restrict buffer SpanCounts { u32 span_counts[]; };
layout(binding = 1) readonly restrict buffer From { uvec2 from[]; };
layout(binding = 2) writeonly restrict buffer To { uvec2 to[]; };

void main() {
    const u32 line = first_line + first_item + gl_GlobalInvocationID.x;
    if (line >= end_line) return;
    const u32 from_begin = (line - from_line) * g.capacity;
    const u32 to_begin = (line - to_line) * larger;
    const u32 count = span_counts[line];
    for (u32 i = 0u; i < count; ++i) to[to_begin + i] = from[from_begin + i];
}
#endif
