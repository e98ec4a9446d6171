// What all samples leave of a box's strips, for cut and keep (docs/design.md, section 4, "exact", 1
// and 3).
#include "portable/bits.h"
#include "portable/chord.h"
#include "portable/distance.h"
#include "portable/stretch.h"

// A box and a radius around it reach over at most 7 x 6 cells of the grid. A set of them is a bit
// each, so many to a column.
#define NEAR_SIDE 8u

// The cells near a box. On a torus each sample has three images in y, of which others than itself
// count only at the edges: first_image is -1 there, and 0 elsewhere.
struct Near {
    Stretch columns;
    Stretch rows;
    i64 first_image;
    u64 touching;  // cells whose samples may take something from the box
};
LACUNA_TYPEDEF(Near)

struct Strip {
    u32 x;
    u32 width;
    u32 begin;
    u32 end;
};
LACUNA_TYPEDEF(Strip)

// What the chords leave of a strip: [low, high), less those of the cells `inside`, which may
// overlap. Most chords cover one of its ends.
struct Rest {
    u32 low;
    u32 high;
    u64 inside;
};
LACUNA_TYPEDEF(Rest)

BODY u64 bit_if(const bool is_set, const u32 number) {
    const u64 bit = is_set ? 1u : 0u;
    return bit << number;
}

BODY u32 cell_of(const Geometry g, const Near near, const u32 number) {
    return nth_of_stretch(near.columns, number / NEAR_SIDE, g.grid_columns) * g.grid_rows +
           nth_of_stretch(near.rows, number % NEAR_SIDE, g.grid_rows);
}

// Of dx and a distance in y. An image's may be 2^32 units, whose square and dx's do not fit 64
// bits: it counts as the domain's height at most. No sample reaches farther, for on a torus no
// radius is larger, and on a box there are no images.
BODY u64 squared_distance(const Geometry g, const u32 dx, const u32 dy) {
    return squared_length(dx, min(dy, g.height));
}

// A bit where the cell's sample takes something from [begin, end) at x, or no bit.
BODY u64 touching_bit(MEMORY const Geometry g, const u32 cell, const u32 number, const u32 x,
                      const u32 period_x, const i64 begin, const i64 end) {
    const u32 sample_x = AT(grid_x, cell);
    const u32 distance = axis_distance(sample_x, x, period_x);
    const u32 dx = distance - min(distance, 1u);
    const u32 dy = nearest_distance(to_i64(AT(grid_y, cell)), begin, end);
    return bit_if(squared_distance(g, dx, dy) < g.radius_squared, number) &
           bit_if(sample_x != NO_SAMPLE, number);
}

// Looks at all cells near a box. Where samples lie cannot be foretold: no branch. A sample that
// takes something from a part of the box, cut at the part's far edge, is no farther than that from
// the middle of the whole, but for 1 where parts are one unit wide.
BODY Near near_of(MEMORY const Geometry g, const Strip box) {
    Near near;
    near.columns = cells_near(box.x, box.x + box.width, g.radius, g.width, g.period_x, g.grid_side,
                              g.grid_columns);
    near.rows =
        cells_near(box.begin, box.end, g.radius, g.height, g.period_y, g.grid_side, g.grid_rows);
    const bool is_at_edge = box.begin < g.radius || g.height - box.end < g.radius;
    near.first_image = to_i64(g.period_y != 0u && is_at_edge ? -1 : 0);
    near.touching = 0u;
    if (max(near.columns.count, near.rows.count) > NEAR_SIDE) ATOMIC_OR(failure, 0, FAILED_CHORDS);
    const u32 middle = box.x + box.width / 2u;
    for (i64 image = near.first_image; image <= -near.first_image; ++image) {
        const i64 begin = to_i64(box.begin) - image * to_i64(g.height);
        const i64 end = begin + to_i64(box.end - box.begin);
        for (u32 i = 0u; i < near.columns.count; ++i) {
            for (u32 j = 0u; j < near.rows.count; ++j) {
                const u32 number = i * NEAR_SIDE + j;
                near.touching = near.touching | touching_bit(ON g, cell_of(g, near, number), number,
                                                             middle, g.period_x, begin, end);
            }
        }
    }
    return near;
}

// A chord covers the strip's whole width: it is cut at the strip's far edge.
BODY u32 cut_distance(const Geometry g, const Strip strip, const u32 x) {
    return axis_distance(x, strip.x + strip.width / 2u, g.period_x) + strip.width / 2u;
}

// Takes the chord [begin, end) of a cell's sample out; its ends may lie outside the domain.
BODY Rest without_chord(const Rest whole, const u32 number, const i64 begin, const i64 end) {
    Rest rest = whole;
    const i64 low = to_i64(rest.low);
    const i64 high = to_i64(rest.high);
    if (end <= low || begin >= high) return rest;
    if (begin <= low)
        rest.low = to_u32(min(end, high));
    else if (end >= high)
        rest.high = to_u32(begin);
    else
        rest.inside = rest.inside | bit_if(true, number);
    return rest;
}

// Most strips are covered by one sample, which shows in squared distances; only where none does,
// roots are taken of the samples that touch the strip.
BODY Rest cut_strip(MEMORY const Geometry g, const Near near, const Strip strip) {
    u64 touching = 0u;
    u64 covering = 0u;
    for (u64 cells = near.touching; cells != 0u; cells = cells & (cells - 1u)) {
        const u32 number = lowest_bit_of_64(cells);
        const u32 cell = cell_of(g, near, number);
        const u32 dx = cut_distance(g, strip, AT(grid_x, cell));
        for (i64 image = near.first_image; image <= -near.first_image; ++image) {
            const i64 y = to_i64(AT(grid_y, cell)) + image * to_i64(g.height);
            const u32 nearest = nearest_distance(y, to_i64(strip.begin), to_i64(strip.end));
            const u32 farthest = farthest_distance(y, to_i64(strip.begin), to_i64(strip.end));
            const u64 least = squared_distance(g, dx, nearest);
            const u64 most = squared_distance(g, dx, farthest);
            touching = touching | bit_if(least < g.radius_squared, number);
            covering = covering | bit_if(most < g.radius_squared, number);
        }
    }
    Rest rest = {strip.begin, covering != 0u ? strip.begin : strip.end, 0u};
    if (covering != 0u) return rest;
    for (u64 cells = touching; cells != 0u; cells = cells & (cells - 1u)) {
        const u32 number = lowest_bit_of_64(cells);
        const u32 cell = cell_of(g, near, number);
        const i64 reach =
            to_i64(chord_reach(cut_distance(g, strip, AT(grid_x, cell)), g.radius_squared));
        for (i64 image = near.first_image; image <= -near.first_image; ++image) {
            const i64 y = to_i64(AT(grid_y, cell)) + image * to_i64(g.height);
            rest = without_chord(rest, number, y - reach + 1, y + reach);
        }
    }
    return rest;
}

// The lowest piece of the rest that begins at `from` or above: [x, y); empty if there is none.
BODY u32x2 next_piece(MEMORY const Geometry g, const Near near, const Strip strip, const Rest rest,
                      const u32 from) {
    u32 begin = from;
    while (begin < rest.high) {
        // The inside chord that covers `begin` moves it up; else the lowest one above ends the
        // piece.
        Rest piece = {begin, rest.high, 0u};
        u32 end = rest.high;
        for (u64 cells = rest.inside; cells != 0u; cells = cells & (cells - 1u)) {
            const u32 cell = cell_of(g, near, lowest_bit_of_64(cells));
            const i64 reach =
                to_i64(chord_reach(cut_distance(g, strip, AT(grid_x, cell)), g.radius_squared));
            for (i64 image = near.first_image; image <= -near.first_image; ++image) {
                const i64 y = to_i64(AT(grid_y, cell)) + image * to_i64(g.height);
                piece = without_chord(piece, 0u, y - reach + 1, y + reach);
                if (y - reach + 1 > to_i64(begin) && y - reach + 1 < to_i64(end))
                    end = to_u32(y - reach + 1);
            }
        }
        if (piece.low == begin) return U32X2(begin, end);
        begin = piece.low;
    }
    return U32X2(rest.high, rest.high);
}

// The box with the number, and one of its strips.
BODY Strip box_at(MEMORY const StripArguments a, const u32 box) {
    Strip all = {AT(box_x, box), a.width << a.is_halved, AT(box_begin, box), AT(box_end, box)};
    return all;
}

BODY Strip part_of(const StripArguments a, const Strip box, const u32 part) {
    Strip strip = {box.x + part * a.width, a.width, box.begin, box.end};
    return strip;
}
