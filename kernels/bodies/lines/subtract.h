// The body of subtract: cuts the chords of the round's samples from the free spans of every line.
#include "portable/chord.h"
#include "portable/column.h"
#include "portable/distance.h"

// A line's spans with a gap between them: [slot, done) lie below the gap, [rest, end) above it.
// Chords come in the order of y, so the gap moves only a little for each, and the chord is cut
// there. The gap has length 0 until a chord first adds a piece. `below` is a copy of the last span
// below the gap, or empty at 0; `above` is the first span above it, or beyond every y.
struct Gap {
    u32 slot;
    u32 done;
    u32 rest;
    u32 end;
    u32 room;   // limit to which `end` may move
    u32 total;  // length of all spans
    bool fits;  // false if the memory did not suffice: then nothing more is cut
    u32x2 below;
    u32x2 above;
};
LACUNA_TYPEDEF(Gap)

BODY u32x2 span_below(MEMORY const Gap gap) {
    return gap.done > gap.slot ? AT(spans, gap.done - 1u) : U32X2(0u, 0u);
}

BODY u32x2 span_above(MEMORY const Gap gap) {
    return gap.rest < gap.end ? AT(spans, gap.rest) : U32X2(NO_SAMPLE, NO_SAMPLE);
}

// Moves the spans above the gap to the end of the memory. If they are there already, nothing fits.
BODY Gap open_gap(MEMORY Gap gap) {
    const u32 shift = gap.room - gap.end;
    for (u32 i = gap.end; i > gap.rest; --i) AT(spans, i - 1u + shift) = AT(spans, i - 1u);
    gap.rest += shift;
    gap.end += shift;
    gap.fits = shift > 0u;
    return gap;
}

// Cuts [begin, end) out of the spans.
BODY Gap cut_out(MEMORY Gap gap, const u32 begin, const u32 end) {
    // Move the gap to the beginning of the chord.
    while (gap.below.y > begin) {
        --gap.rest;
        --gap.done;
        gap.above = gap.below;
        if (gap.done < gap.rest) AT(spans, gap.rest) = gap.above;
        gap.below = span_below(ON gap);
    }
    while (gap.above.y <= begin) {
        gap.below = gap.above;
        if (gap.done < gap.rest) AT(spans, gap.done) = gap.below;
        ++gap.done;
        ++gap.rest;
        gap.above = span_above(ON gap);
    }

    // Keep the part of the chord's first span that lies below the chord.
    if (gap.above.x < begin) {
        const bool is_inside = gap.above.y > end;  // one piece more than before
        if (is_inside && gap.done == gap.rest) gap = open_gap(ON gap);
        if (!gap.fits) return gap;
        gap.total -= (is_inside ? end : gap.above.y) - begin;
        gap.below = U32X2(gap.above.x, begin);
        if (is_inside) {
            gap.above.x = end;
            AT(spans, gap.rest) = gap.above;
        } else {
            ++gap.rest;
            gap.above = span_above(ON gap);
        }
        AT(spans, gap.done) = gap.below;
        ++gap.done;
    }

    // Drop covered spans, and keep the part of the chord's last span that lies above the chord.
    while (gap.above.y <= end) {
        gap.total -= gap.above.y - gap.above.x;
        ++gap.rest;
        gap.above = span_above(ON gap);
    }
    if (gap.above.x < end) {
        gap.total -= end - gap.above.x;
        gap.above.x = end;
        AT(spans, gap.rest) = gap.above;
    }
    return gap;
}

// In exact the chord covers the strip's whole width: it is computed at the strip's far edge.
BODY u32 reach_on(const Geometry g, const u32 centre, const u32 x) {
    return chord_reach(axis_distance(x, centre, g.period_x) + g.chord_margin, g.radius_squared);
}

// Serves one line. If its memory does not suffice, it raises `overflow` and keeps the spans without
// some cuts: the host repeats the cut with more memory. Does nothing while admission is unfinished.
BODY void serve_subtract(MEMORY const SlabArguments a, const u32 item) {
    const u32 line = a.first_line + item;
    if (line >= a.end_line || AT(undecided, a.last_pass) != 0u) return;
    const Geometry g = a.g;
    const u32 column = column_of_line(line, g.lines, g.columns);
    const u32 near_begin = AT(near_begins, column);
    const u32 near_end = near_begin + AT(near_counts, column);
    const u32 count = AT(span_counts, line);
    if (near_begin == near_end || count == 0u) return;

    const u32 centre = line * g.strip_width + g.strip_width / 2u;
    const u32 slot = (line - a.slab_begin) * g.capacity;
    const u32 room = min(g.capacity, count + (near_end - near_begin) + 2u);
    Gap gap = {slot,         slot,          slot,
               slot + count, slot + room,   AT(free_lengths, line),
               true,         U32X2(0u, 0u), AT(spans, slot)};

    // On a torus, a disk that extends beyond one end is cut at the other end.
    u32 bottom = 0u;
    u32 top = g.height;
    if (g.period_y != 0u) {
        for (u32 i = near_end; i > near_begin; --i) {
            const u32x2 s = AT(near, i - 1u);
            if (g.height - s.y > g.radius) break;
            bottom = max(bottom, window_end(2u, s.y, reach_on(g, centre, s.x), g.height));
        }
        for (u32 i = near_begin; i < near_end; ++i) {
            const u32x2 s = AT(near, i);
            if (s.y >= g.radius) break;
            top = min(top, window_begin(1u, s.y, reach_on(g, centre, s.x), g.height));
        }
    }

    // Cut the chords from the bottom up.
    if (bottom > 0u) gap = cut_out(ON gap, 0u, bottom);
    for (u32 i = near_begin; i < near_end && gap.fits; ++i) {
        const u32x2 s = AT(near, i);
        const u32 reach = reach_on(g, centre, s.x);
        if (reach == 0u) continue;
        gap = cut_out(ON gap, window_begin(0u, s.y, reach, g.height),
                      window_end(0u, s.y, reach, g.height));
    }
    if (top < g.height && gap.fits) gap = cut_out(ON gap, top, g.height);
    if (!gap.fits) ATOMIC_SET(overflow, 0, 1u);

    // Close the gap.
    if (gap.done == gap.rest) gap.done = gap.rest = gap.end;
    while (gap.rest < gap.end) {
        AT(spans, gap.done) = AT(spans, gap.rest);
        ++gap.done;
        ++gap.rest;
    }
    AT(span_counts, line) = gap.done - slot;
    AT(free_lengths, line) = gap.total;
    CHECK_TURNS(g.height, FAILED_SUBTRACT);
}
