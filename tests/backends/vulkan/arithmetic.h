// All of the portable arithmetic on one set of numbers: the same text for C++ and for GLSL.
#ifndef LACUNA_TESTS_VULKAN_ARITHMETIC_H
#define LACUNA_TESTS_VULKAN_ARITHMETIC_H
#include "portable/bits.h"
#include "portable/chord.h"
#include "portable/column.h"
#include "portable/distance.h"
#include "portable/failure.h"
#include "portable/isqrt.h"
#include "portable/metric.h"
#include "portable/sample_grid.h"
#include "portable/window.h"

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
    u32 wraps;
    u32 side;
    u32 unused;
};

struct Answers {
    u64 root;
    u32 distance;
    u32 is_conflict;
    u32 reach;
    u32 begin;
    u32 end;
    u32 wrapped_begin;
    u32 wrapped_end;
    u32 low_0;
    u32 low_1;
    u32 low_2;
    u32 high_0;
    u32 high_1;
    u32 high_2;
    u32 column;
    u32 first_line;
    u32 neighbours;
    u32 first;
    u32 bucket;
    u32 cells;
    u32 near_first;
    u32 near_count;
    u32 turns_left;
    u32 twice;
    u32 mask;
    u32 bit;
    u32 lines_first;
    u32 lines_count;
    u32 columns_first;
    u32 columns_count;
    u32 bound;
    u64 metric_squared;
};

LACUNA_FN Answers answer(Numbers q) {
    Answers a;
    a.root = isqrt(q.n);
    a.distance = axis_distance(q.ax, q.bx, q.period_x);
    a.is_conflict =
        conflicts(q.ax, q.ay, q.bx, q.by, q.period_x, q.period_y, q.radius_squared) ? 1u : 0u;
    a.reach = chord_reach(a.distance, q.radius_squared);
    a.begin = chord_begin(q.ay, a.reach);
    a.end = chord_end(q.ay, a.reach, q.height);
    a.wrapped_begin = chord_wrapped_begin(q.ay, a.reach, q.height);
    a.wrapped_end = chord_wrapped_end(q.ay, a.reach, q.height);
    a.low_0 = window_low(0u, q.ay, q.radius, q.height);
    a.low_1 = window_low(1u, q.ay, q.radius, q.height);
    a.low_2 = window_low(2u, q.ay, q.radius, q.height);
    a.high_0 = window_high(0u, q.ay, q.radius, q.height);
    a.high_1 = window_high(1u, q.ay, q.radius, q.height);
    a.high_2 = window_high(2u, q.ay, q.radius, q.height);
    a.column = column_of_line(q.line, q.lines, q.columns);
    a.first_line = first_line_of_column(a.column, q.lines, q.columns);
    a.neighbours = neighbour_count(a.column, q.columns, q.wraps);
    a.first = first_neighbour(a.column, q.columns, q.wraps);
    a.bucket = bucket_of(q.ay, q.columns, q.height);
    a.cells = count_grid(q.height, q.side);
    GridStretch near =
        grid_stretch(q.by, q.by + 1u, q.radius, q.height, q.period_y, q.side, a.cells);
    a.near_first = near.first;
    a.near_count = near.count;
    a.turns_left = has_turns_left(q.ax) ? 1u : 0u;
    a.twice = twice_metric_radius(q.line % 3u, q.ax + 1u, q.bx + 1u);
    a.metric_squared = metric_squared(a.twice);
    u32 end = q.ay / 2u + q.by / 2u + 1u;
    a.mask = word_mask((end - 1u) / 32u, q.ay / 2u, end);
    a.bit = bit_of_rank(q.radius, q.by % count_bits(q.radius));
    Stretch lines = near_lines(q.line, q.radius % 0x40000000u, q.lines, q.period_x);
    Stretch columns = near_columns(lines, q.lines, q.columns);
    a.lines_first = lines.first;
    a.lines_count = lines.count;
    a.columns_first = columns.first;
    a.columns_count = columns.count;
    a.bound = class_bound(q.radius);
    return a;
}

LACUNA_END

#endif
