// The portable arithmetic, for a test that compares it with C++: one work item an input.
#include "portable/bits.h"
#include "portable/sample_grid.h"
#include "portable/chord.h"
#include "portable/column.h"
#include "portable/distance.h"
#include "portable/failure.h"
#include "portable/isqrt.h"
#include "portable/metric.h"
#include "portable/window.h"

// The same layout as Input in portable_test.cpp.
typedef struct Input {
    u64 n, radius_squared;
    u32 ax, ay, bx, by, width, height, radius, reach;
    u32 column, line, lines, columns;
} Input;

#define OUTPUTS 35u

kernel void portable(global const Input* inputs, global u64* outputs) {
    const u32 i = (u32)get_global_id(0);
    const Input in = inputs[i];
    global u64* out = outputs + (u64)i * OUTPUTS;
    out[0] = isqrt(in.n);
    out[1] = axis_distance(in.ax, in.bx, in.width);
    out[2] = axis_distance(in.ax, in.bx, 0u);
    out[3] = squared_length(in.ax, in.ay);
    out[4] = conflicts(in.ax, in.ay, in.bx, in.by, in.width, in.height, in.radius_squared);
    out[5] = conflicts(in.ax, in.ay, in.bx, in.by, 0u, 0u, in.radius_squared);
    out[6] = chord_reach(in.bx, in.radius_squared);
    out[7] = chord_begin(in.ay, in.reach);
    out[8] = chord_end(in.ay, in.reach, in.height);
    out[9] = chord_wrapped_begin(in.ay, in.reach, in.height);
    out[10] = chord_wrapped_end(in.ay, in.reach, in.height);
    for (u32 window = 0u; window < 3u; ++window) {
        const u64 low = window_low(window, in.ay, in.radius, in.height);
        out[11u + window] = low << 32 | window_high(window, in.ay, in.radius, in.height);
    }
    out[14] = first_line_of_column(in.column, in.lines, in.columns);
    out[15] = column_of_line(in.line, in.lines, in.columns);
    out[16] = neighbour_count(in.column, in.columns, 0u);
    out[17] = neighbour_count(in.column, in.columns, 1u);
    out[18] = first_neighbour(in.column, in.columns, 0u);
    out[19] = first_neighbour(in.column, in.columns, 1u);
    out[20] = grid_side(in.radius_squared);
    out[21] = count_grid(in.height, in.radius);
    const u32 begin = min(in.ay, in.by);
    const u32 end = max(in.ay, in.by) + 1u;
    for (u32 i = 0u; i < 2u; ++i) {
        const u32 period = i == 0u ? 0u : in.height;
        const u32 count = count_grid(in.height, in.radius);
        const GridStretch run =
            grid_stretch(begin, end, in.reach, in.height, period, in.radius, count);
        const u64 first = run.first;
        out[22u + i] = first << 32 | run.count;
        out[24] = nth_of_stretch(run, run.count - 1u, count);
    }
    out[25] = has_turns_left(in.ay);
    out[26] = word_mask((end - 1u) / 32u, begin, end);
    out[27] = bit_of_rank(in.radius, (in.ax | in.ay) % count_bits(in.radius));
    const Stretch near = near_lines(in.line, in.reach, in.lines, in.ax);
    out[28] = (u64)near.first << 32 | near.count;
    const Stretch columns = near_columns(near, in.lines, in.columns);
    out[29] = (u64)columns.first << 32 | columns.count;
    const u32 twice = twice_metric_radius(in.column % 3u, in.radius % 0x20000000u + 1u,
                                          in.reach % 0x20000000u + 1u);
    out[30] = twice;
    out[31] = metric_squared(twice);
    out[32] = bucket_of(in.ay, in.columns, in.height);
    out[33] = radius_class(in.radius);
    out[34] = class_bound(in.radius);
}
