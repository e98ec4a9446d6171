// The body of subtract: cuts the chords of the round's samples from the free spans of every tile of
// every line.
#include "portable/chord.h"
#include "portable/column.h"
#include "portable/distance.h"

// A tile's spans with a gap between them: [slot, done) lie below the gap, [rest, end) above it.
// Chords come in the order of rows of cells, so the gap moves only a little for each, and the chord
// is cut there. The gap has length 0 until a chord first adds a piece. `below` is a copy of the
// last span below the gap, or empty at 0; `above` is the first span above it, or beyond every y.
struct Gap {
    u32 slot;
    u32 done;
    u32 rest;
    u32 end;
    u32 room;   // limit to which `end` may move
    u32 total;  // length of all spans
    bool fits;  // false if the memory did not suffice: then nothing more is cut
    Span below;
    Span above;
};
LACUNA_TYPEDEF(Gap)

BODY Span span_below(MEMORY const Gap gap) {
    if (gap.done > gap.slot) return LOAD(Span, spans, gap.done - 1u);
    return span_of(0u, 0u);
}

BODY Span span_above(MEMORY const Gap gap) {
    if (gap.rest < gap.end) return LOAD(Span, spans, gap.rest);
    return span_of(NO_SAMPLE, NO_SAMPLE);
}

// Moves the spans above the gap to the end of the memory. If they are there already, nothing fits.
BODY Gap open_gap(MEMORY Gap gap) {
    const u32 shift = gap.room - gap.end;
    for (u32 i = gap.end; i > gap.rest; --i)
        STORE(spans, i - 1u + shift, LOAD(Span, spans, i - 1u));
    gap.rest += shift;
    gap.end += shift;
    gap.fits = shift > 0u;
    return gap;
}

// Cuts [begin, end) out of the spans.
BODY Gap cut_out(MEMORY Gap gap, const u32 begin, const u32 end) {
    // Move the gap to the beginning of the chord.
    while (gap.below.end > begin) {
        --gap.rest;
        --gap.done;
        gap.above = gap.below;
        if (gap.done < gap.rest) STORE(spans, gap.rest, gap.above);
        gap.below = span_below(ON gap);
    }
    while (gap.above.end <= begin) {
        gap.below = gap.above;
        if (gap.done < gap.rest) STORE(spans, gap.done, gap.below);
        ++gap.done;
        ++gap.rest;
        gap.above = span_above(ON gap);
    }

    // Keep the part of the chord's first span that lies below the chord.
    if (gap.above.begin < begin) {
        const bool is_inside = gap.above.end > end;  // one piece more than before
        if (is_inside && gap.done == gap.rest) gap = open_gap(ON gap);
        if (!gap.fits) return gap;
        gap.total -= (is_inside ? end : gap.above.end) - begin;
        gap.below = span_of(gap.above.begin, begin);
        if (is_inside) {
            gap.above.begin = end;
            STORE(spans, gap.rest, gap.above);
        } else {
            ++gap.rest;
            gap.above = span_above(ON gap);
        }
        STORE(spans, gap.done, gap.below);
        ++gap.done;
    }

    // Drop covered spans, and keep the part of the chord's last span that lies above the chord.
    while (gap.above.end <= end) {
        gap.total -= gap.above.end - gap.above.begin;
        ++gap.rest;
        gap.above = span_above(ON gap);
    }
    if (gap.above.begin < end) {
        gap.total -= end - gap.above.begin;
        gap.above.begin = end;
        STORE(spans, gap.rest, gap.above);
    }
    return gap;
}

// In exact the chord covers the strip's whole width: it is computed at the strip's far edge.
BODY u32 reach_on(const Geometry g, const u32 centre, const u32 x) {
    return chord_reach(axis_distance(x, centre, g.period_x) + g.chord_margin, g.radius_squared);
}

// Cuts the chords of a sample on a line with this centre from the tile [begin, end).
BODY Gap cut_by_sample(MEMORY const Geometry g, const Gap all, const u32 centre, const Spot near_by,
                       const u32 windows, const u32 begin, const u32 end) {
    Gap gap = all;
    const u32 reach = reach_on(g, centre, near_by.x);
    // All lines of a column agree about the end, so their items stay together.
    const bool is_at_end = near_by.y < g.radius || g.height - near_by.y <= g.radius;
    const u32 of_sample = reach == 0u ? 0u : is_at_end ? windows : 1u;
    for (u32 window = 0u; window < of_sample; ++window) {
        const u32 low = max(window_begin(window, near_by.y, reach, g.height), begin);
        const u32 high = min(window_end(window, near_by.y, reach, g.height), end);
        if (low < high && gap.fits) gap = cut_out(ON gap, low, high);
    }
    return gap;
}

// Serves one tile; neighbouring items serve neighbouring lines, which the same samples cut. If its
// memory does not suffice, it sets report[OVERFLOW_WORD] and keeps the spans without some cuts: the
// host repeats the cut with more memory. Does nothing while admission is unfinished.
BODY void serve_subtract(MEMORY const SlabArguments a, const u32 item) {
    const u32 lines = (a.end_tile - a.first_tile) / a.tiles;
    if (item >= a.end_tile - a.first_tile || AT(report, a.last_pass) != 0u) return;
    const Geometry g = a.g;
    const u32 line = a.first_tile / a.tiles + item % lines;
    const u32 tile = line * a.tiles + item / lines;
    const u32 list = column_of_line(line, g.lines, g.columns) * a.tiles + item / lines;
    const u32 count = AT(span_counts, tile);
    const u32 near_end = list * a.near_room + AT(near_counts, list);
    if (count == 0u || near_end == list * a.near_room) return;

    const u32 centre = line * g.strip_width + g.strip_width / 2u;
    const u32 begin = item / lines * a.tile_height;
    const u32 end = begin + min(a.tile_height, g.height - begin);
    // On a torus, a disk that extends beyond one end is cut at the other end.
    const bool is_at_edge = begin < g.radius || g.height - end < g.radius;
    const u32 windows = g.period_y != 0u && is_at_edge ? 3u : 1u;
    const u32 slot = (tile - a.slab_begin) * g.capacity;
    Gap gap = {slot,
               slot,
               slot,
               slot + count,
               slot + g.capacity,
               AT(tile_lengths, tile),
               true,
               span_of(0u, 0u),
               LOAD(Span, spans, slot)};
    for (u32 i = list * a.near_room; i < near_end && gap.fits; ++i)
        gap = cut_by_sample(ON g, gap, centre, LOAD(Spot, near, i), windows, begin, end);
    if (!gap.fits) ATOMIC_SET(report, OVERFLOW_WORD, 1u);

    // Close the gap.
    if (gap.done == gap.rest) gap.done = gap.rest = gap.end;
    while (gap.rest < gap.end) {
        STORE(spans, gap.done, LOAD(Span, spans, gap.rest));
        ++gap.done;
        ++gap.rest;
    }
    AT(span_counts, tile) = gap.done - slot;
    AT(tile_lengths, tile) = gap.total;
    CHECK_TURNS(g.height, FAILED_SUBTRACT);
}
