// All of the portable arithmetic on one set of numbers: the same text for C++, OpenCL C
// and GLSL.
#ifndef LACUNA_TESTS_DEVICE_ARITHMETIC_H
#define LACUNA_TESTS_DEVICE_ARITHMETIC_H
#include "portable/bits.h"
#include "portable/chord.h"
#include "portable/column.h"
#include "portable/distance.h"
#include "portable/ellipse.h"
#include "portable/failure.h"
#include "portable/isqrt.h"
#include "portable/metric.h"
#include "portable/power.h"
#include "portable/stretch.h"

LACUNA_BEGIN

struct Numbers {
    u64 n;
    u64 radius_squared;
    u32 ax;
    u32 ay;
    u32 bx;
    u32 by;
    u32 period_x;
    u32 period_y;
    u32 radius;
    u32 height;
    u32 line;
    u32 lines;
    u32 columns;
    u32 side;
};
LACUNA_TYPEDEF(Numbers)

struct Answers {
    u64 root;
    u64 metric_squared;
    u64 weight;
    u64 bounded_weight;
    u64 reach_of_weight;
    Interval chord;
    u32 is_held;
    u32 window_height;
    u32 distance;
    u32 is_conflict;
    u32 reach;
    u32 begins[3];
    u32 ends[3];
    u32 nearest;
    u32 farthest;
    u32 column;
    u32 first_line;
    u32 bucket;
    u32 cells;
    Stretch cells_near;
    u32 last_near;
    Stretch lines;
    Stretch columns;
    u32 turns_left;
    u32 twice;
    u32 mask;
    u32 bit;
    u32 radius_class;
    u32 bound;
    u32 centre;
    u32 place;
};
LACUNA_TYPEDEF(Answers)

// A step of a relaxed sample, within the limits of portable/power.h.
LACUNA_FN Answers relaxed(Answers a, Numbers q) {
    u64 one = 1u;
    RelaxLattice lattice;
    lattice.farthest = q.n / 4u + 2u;
    lattice.mean_mass = q.radius_squared % (one << 40u) + 1u;
    lattice.lonely_step = q.radius_squared % (one << 28u) + 1u;
    lattice.step_x = 256u;
    lattice.step_y = 256u + q.by % 256u;
    u64 mass = q.line % 4u == 0u ? lattice.mean_mass : (one << (q.line % 47u)) + q.ax - 1u;
    u64 weight = q.line % 3u == 0u ? 0u : q.radius_squared % (lattice.farthest + 1u);
    a.weight = moved_weight(lattice, weight, q.line % 5u == 0u ? 0u : mass, q.ay);
    a.bounded_weight = bounded_weight(lattice.farthest, weight, q.n / 8u);
    a.reach_of_weight = reach_of_weight(lattice.farthest, weight);
    u32 length = (q.columns % 2097151u + 1u) * 256u;
    u32 period = q.period_x == 0u ? 0u : length;
    u64 moment = q.columns % 2097151u + 1u;
    mass = mass % (one << 40u) + 1u;
    a.centre = centre_of_mass(moment * mass + q.n % mass, mass, q.ax % length, 256u,
                              q.columns % 2097151u + 1u, period);
    a.place = moved_place(q.ax % length, q.bx % length, q.line % LONG_WAY, length, period);
    return a;
}

LACUNA_FN Answers answer(Numbers q) {
    Answers a;
    a.root = isqrt(q.n);
    a.distance = axis_distance(q.ax, q.bx, q.period_x);
    a.is_conflict =
        are_closer(q.ax, q.ay, q.bx, q.by, q.period_x, q.period_y, q.radius_squared) ? 1u : 0u;
    a.reach = chord_reach(a.distance, q.radius_squared);
    for (u32 window = 0u; window < 3u; ++window) {
        a.begins[window] = window_begin(window, q.ay, a.reach, q.height);
        a.ends[window] = window_end(window, q.ay, a.reach, q.height);
    }
    // The point's image above or below the domain.
    i64 image = q.line % 2u == 0u ? to_i64(q.height) : -to_i64(q.height);
    i64 y = to_i64(q.ay) + image;
    i64 first = to_i64(q.by);
    a.nearest = nearest_distance(y, first, first + to_i64(q.side));
    a.farthest = farthest_distance(y, first, first + to_i64(q.side));
    a.column = column_of_line(q.line, q.lines, q.columns);
    a.first_line = first_line_of_column(a.column, q.lines, q.columns);
    a.bucket = bucket_of(q.ay, q.columns, q.height);
    a.cells = (q.height - 1u) / q.side + 1u;
    a.cells_near = cells_near(q.by, q.by + 1u, q.radius, q.height, q.period_y, q.side, a.cells);
    a.last_near = nth_of_stretch(a.cells_near, a.cells_near.count - 1u, a.cells);
    a.lines = stretch_around(q.line, q.radius, q.lines, q.period_x);
    a.columns = columns_of_stretch(a.lines, q.lines, q.columns);
    a.turns_left = has_turns_left(q.ax) ? 1u : 0u;
    a.twice = twice_metric_radius(q.line % 3u, q.ax % 0x20000000u + 1u, q.bx % 0x20000000u + 1u);
    a.metric_squared = metric_squared(a.twice);
    u32 end = q.ay / 2u + q.by / 2u + 1u;
    a.mask = word_mask((end - 1u) / 32u, q.ay / 2u, end);
    a.bit = bit_of_rank(q.radius, q.by % count_bits(q.radius));
    a.radius_class = radius_class(q.radius);
    a.bound = class_bound(q.radius);
    // An ellipse of any map, and an offset of at most 2^30.
    Ellipse ellipse;
    ellipse.p = q.ax % 0x80000000u;
    ellipse.q = q.radius;
    ellipse.s = q.bx % 0x7fffffffu + 1u;
    ellipse.shift = q.line % 32u;
    i64 dx = (q.line % 3u == 0u ? -1 : 1) * to_i64(q.ay % 0x40000000u);
    i64 dy = (q.line % 5u == 0u ? -1 : 1) * to_i64(q.by % 0x40000000u);
    a.is_held = holds(ellipse, dx, dy) ? 1u : 0u;
    a.chord = common_part(chord_around(ellipse, dx, to_i64(q.columns % 4u)),
                          chord_around(circle_of(q.radius % 0x80000000u + 2u), dx, 0));
    a.window_height = height_in_window(q.line % 3u, way_to(dx, dy, q.period_x), q.height);
    return relaxed(a, q);
}

LACUNA_END

#endif
