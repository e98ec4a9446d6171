// The neighbour index where there is one radius: the sample grid. A box and a radius around it
// reach over at most 7 x 6 cells, each with at most one sample. The other index is lists.h.
#include "bodies/exact/strip.h"
#include "portable/bits.h"
#include "portable/conflict.h"
#include "portable/stretch.h"

// Near::cells has this many bits for each column of the cells near a box, one for each cell.
#define NEAR_SIDE 8u

// The cells near a box, and a bit for each whose sample may cut the box.
struct Near {
    Stretch columns;
    Stretch rows;
    u64 cells;
};
LACUNA_TYPEDEF(Near)

// A walk through the samples near a box: the bits of the cells still to visit.
struct Walk {
    u64 cells;
};
LACUNA_TYPEDEF(Walk)

BODY HalvedBox box_at(MEMORY const StripArguments a, const u32 number) {
    const Strip whole = {LOAD(Box, boxes, number), a.g.radius, true};
    return uncut(whole);
}

BODY Strip strip_of(const StripArguments a, const HalvedBox box, const u32 k) {
    Strip strip = box.whole;
    if (a.strip_bits != 0u) strip.at = half_of(strip.at, k);
    return strip;
}

BODY u32 cell_of(const Geometry g, const Near near, const u32 number) {
    return nth_of_stretch(near.columns, number / NEAR_SIDE, g.grid_columns) * g.grid_rows +
           nth_of_stretch(near.rows, number % NEAR_SIDE, g.grid_rows);
}

// Bit `number`, if the cell's sample may cut the box or one of its strips; otherwise 0. A chord is
// cut at the far edge of a strip, which is at least as far as the middle of the box, less 1 unit
// where strips are one unit wide.
BODY u64 bit_of_cell(MEMORY const Geometry g, const Box box, const u32 cell, const u32 number) {
    const u32 x = AT(grid_x, cell);
    const u32 distance = axis_distance(x, box.x + box.width / 2u, g.period_x);
    const u32 dx = distance - min(distance, 1u);
    const u32 dy = distance_to_stretch(AT(grid_y, cell), box.begin, box.end, g.period_y);
    const u64 bit = x != NO_SAMPLE && squared_length(dx, dy) < g.radius_squared ? 1u : 0u;
    return bit << number;
}

BODY Near near_of(MEMORY const StripArguments a, const u32 number, const HalvedBox box) {
    const Geometry g = a.g;
    const Box at = box.whole.at;
    Near near;
    near.columns = cells_near(at.x, at.x + at.width, g.radius, g.width, g.period_x, g.grid_side,
                              g.grid_columns);
    near.rows =
        cells_near(at.begin, at.end, g.radius, g.height, g.period_y, g.grid_side, g.grid_rows);
    near.cells = 0u;
    if (max(near.columns.count, near.rows.count) > NEAR_SIDE)
        ATOMIC_OR(report, FAILURE_WORD, FAILED_CHORDS);
    // No branch: where samples lie cannot be predicted.
    for (u32 i = 0u; i < near.columns.count; ++i) {
        for (u32 j = 0u; j < near.rows.count; ++j) {
            const u32 bit = i * NEAR_SIDE + j;
            near.cells = near.cells | bit_of_cell(ON g, at, cell_of(g, near, bit), bit);
        }
    }
    return near;
}

BODY Walk walk_over(const StripArguments a, const Near near) {
    const Walk walk = {near.cells};
    return walk;
}

BODY bool has_sample(const StripArguments a, const Near near, const Walk walk) {
    return walk.cells != 0u;
}

// A neighbour's x as the strip sees it, and the square of the distance that it keeps: lists.h,
// where there are classes of samples, has more to do.
BODY u32 x_of(const StripArguments a, const Neighbour neighbour, const Strip strip) {
    return neighbour.x;
}
BODY u64 limit_near(MEMORY const StripArguments a, const Neighbour neighbour, const Strip strip) {
    return a.g.radius_squared;
}

// The part of the strip's whole width that a sample takes, as far up as down from its height.
struct Chord {
    u32 y;
    u32 reach;
};
LACUNA_TYPEDEF(Chord)

BODY Chord chord_of(MEMORY const StripArguments a, const Strip strip, const Neighbour neighbour) {
    const Chord chord = {neighbour.y,
                         chord_reach(cut_distance(a.g, strip, neighbour.x), a.g.radius_squared)};
    return chord;
}
BODY u32 begin_of_chord(const Geometry g, const Chord chord, const u32 window) {
    return window_begin(window, chord.y, chord.reach, g.height);
}
BODY u32 end_of_chord(const Geometry g, const Chord chord, const u32 window) {
    return window_end(window, chord.y, chord.reach, g.height);
}

// There is no list, so `next` is 0.
BODY Neighbour sample_at(MEMORY const StripArguments a, const Near near, const Walk walk) {
    const u32 cell = cell_of(a.g, near, lowest_bit_of_64(walk.cells));
    const Neighbour neighbour = {AT(grid_x, cell), AT(grid_y, cell), a.g.radius, 0u};
    return neighbour;
}

BODY Walk walk_past(const Near near, const Walk walk, const Neighbour neighbour) {
    const Walk next = {walk.cells & (walk.cells - 1u)};
    return next;
}

// The host needs only the length of a new box: all have the same radius and the same width.
BODY void keep_origin(MEMORY const u32 from, const Strip strip, const Box box, const u32 to) {
    AT(results, to) = box.end - box.begin;
}
