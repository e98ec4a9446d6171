// The conflict rule of mode exact: whether two samples are too close, and what a sample takes from
// a line through an active box. This is the paper's metric min (4.2.1): of two radii the smaller
// counts. With one radius for all samples, the two radii are equal. Two classes of samples keep
// that radius times their factor (class_copies.h). With one class the factor is FACTOR_ONE.
//
// A rule must ensure that every point of the box on a chord conflicts with the sample. `box_radius`
// is therefore the least radius under the box.
#ifndef LACUNA_PORTABLE_CONFLICT_H
#define LACUNA_PORTABLE_CONFLICT_H
#include "chord.h"
#include "class_copies.h"
#include "distance.h"
#include "ellipse.h"

LACUNA_BEGIN

// A sample or a candidate, with the radius that the radius field has there.
struct Sized {
    u32 x;
    u32 y;
    u32 radius;
};
LACUNA_TYPEDEF(Sized)

// The square of the distance that samples of these radii must keep.
LACUNA_FN u64 squared_limit(u32 radius_a, u32 radius_b, u64 factor) {
    u64 limit = times_factor(radius_a < radius_b ? radius_a : radius_b, factor);
    return limit * limit;
}

// Both must have the x of one copy.
LACUNA_FN bool conflicts(Sized a, Sized b, u64 factor, u32 period_x, u32 period_y) {
    return are_closer(a.x, a.y, b.x, b.y, period_x, period_y,
                      squared_limit(a.radius, b.radius, factor));
}

// How far the chord reaches up and down from the sample's height (see chord_reach), on a line at
// distance dx from the sample.
LACUNA_FN u32 chord(Sized neighbour, u32 dx, u32 box_radius, u64 factor) {
    return chord_reach(dx, squared_limit(neighbour.radius, box_radius, factor));
}

// Whether a sample's disk holds a whole box, so that every candidate there conflicts with it. The
// distances from the far edges are computed as for a chord.
LACUNA_FN bool covers_box(Sized one, u32 x, u32 width, u32 begin, u32 end, u32 box_radius,
                          u64 factor, u32 period_x, u32 period_y) {
    u32 half_width = width / 2u;
    u32 half_height = (end - begin) / 2u;
    return squared_length(axis_distance(one.x, x + half_width, period_x) + half_width,
                          axis_distance(one.y, begin + half_height, period_y) + half_height) <
           squared_limit(one.radius, box_radius, factor);
}

// The same with ellipses. Two samples conflict if each lies in the other's.
LACUNA_FN bool ellipses_conflict(Sized a, Ellipse of_a, Sized b, Ellipse of_b, u32 period_x,
                                 u32 period_y) {
    i64 dx = way_to(to_i64(a.x), to_i64(b.x), period_x);
    i64 dy = way_to(to_i64(a.y), to_i64(b.y), period_y);
    return holds(of_a, dx, dy) && holds(of_b, dx, dy);
}

// The heights that a sample at x takes from the columns [first, first + width) of a box, as offsets
// from its own height. `of_box` is the ellipse of all samples in the box, or a circle that lies in
// all their ellipses.
LACUNA_FN Interval ellipse_chord(u32 x, Ellipse of_sample, u32 first, u32 width, Ellipse of_box,
                                 u32 period_x) {
    i64 reach = to_i64(width / 2u);
    i64 dx = way_to(to_i64(x), to_i64(first) + reach, period_x);
    Interval chord = chord_around(of_sample, dx, reach);
    if (!are_same(of_sample, of_box)) chord = common_part(chord, chord_around(of_box, dx, reach));
    return chord;
}

// Whether the ellipse around a sample holds nothing of a box, on a torus not even around an edge.
// May return false although the ellipse misses the box.
LACUNA_FN bool ellipse_misses(Sized one, Ellipse of_one, u32 x, u32 width, u32 begin, u32 end,
                              u32 period_x, u32 period_y) {
    const i64 most = to_i64(one.radius);  // of a circle that holds the ellipse
    bool is_missed = true;
    for (u32 image = 0u; image < (period_x == 0u ? 1u : 9u) && is_missed; ++image) {
        const i64 left = to_i64(x) - to_i64(one.x) + shift_of_image(image % 3u, period_x);
        const i64 low = to_i64(begin) - to_i64(one.y) + shift_of_image(image / 3u, period_y);
        const Interval columns = cut_to(left, left + to_i64(width), most);
        const Interval rows = cut_to(low, low + to_i64(end - begin), most);
        is_missed = columns.begin >= columns.end || rows.begin >= rows.end ||
                    misses(of_one, columns.begin, columns.end - 1, rows.begin, rows.end - 1);
    }
    return is_missed;
}

LACUNA_END

#endif
