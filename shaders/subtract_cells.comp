// subtract in mode cells: the lattice points that the round's samples block, taken out of every
// line by the two-way check of section 4.2, a pixel's run of points at a time.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#include "portable/bits.h"
#include "portable/chord.h"
#include "portable/column.h"
#include "portable/distance.h"
#include "portable/failure.h"
#include "portable/fate.h"
#include "portable/geometry.h"
#include "portable/metric.h"

layout(local_size_x_id = 0) in;

// An invocation serves one of so many `slices` of the lines near a candidate: every slices-th line.
// Candidates whose samples reach farther than most_reach would take it too many turns: they are
// left for the next dispatch, which takes what is_listed in `todo` with more slices. Does nothing
// while admission is unsettled (undecided[last_pass] != 0).
layout(push_constant) uniform Arguments { u32 first_item; Geometry g; u32 words; u32 rows;
                                          u32 metric; u32 last_pass; u32 count; u32 slices;
                                          u32 most_reach; u32 is_listed; };
layout(binding = 0) readonly restrict buffer Undecided { u32 undecided[]; };
layout(binding = 1) readonly restrict buffer Candidates { uvec4 candidates[]; };
layout(binding = 2) readonly restrict buffer Fates { u32 fates[]; };
layout(binding = 3) readonly restrict buffer ColumnOf { u32 column_of[]; };
layout(binding = 4) readonly restrict buffer RowOf { u32 row_of[]; };
layout(binding = 5) readonly restrict buffer RowBegins { u32 row_begins[]; };
layout(binding = 6) readonly restrict buffer PixelRadii { u32 pixel_radii[]; };
layout(binding = 7) readonly restrict buffer PixelReaches { u32 pixel_reaches[]; };
layout(binding = 8) readonly restrict buffer WidestRows { u32 widest_rows[]; };
layout(binding = 9) coherent restrict buffer Widest { u32 widest[]; };
layout(binding = 10) coherent restrict buffer Bits { u32 bits[]; };
layout(binding = 11) coherent restrict buffer FreeLengths { u32 free_lengths[]; };
layout(binding = 12) readonly restrict buffer Todo { u32 todo[]; };
layout(binding = 13) writeonly restrict buffer Left { u32 left[]; };
layout(binding = 14) coherent restrict buffer LeftCount { u32 left_count; };
layout(binding = 15) coherent restrict buffer Failure { u32 failure; };

// One sample on one line.
struct Cut {
    u32 radius;
    u32 dx;
    u32 line_begin;   // its first word
    u32 pixel_begin;  // the first of its pixels
    u32 last_twice;   // neighbouring pixels are often alike
    u32 last_reach;
    u32 blocked;  // points
};

// Half the chord that the metric of the sample and a pixel's radius makes.
u32 reach_to(inout Cut cut, const u32 other) {
    const u32 twice = twice_metric_radius(metric, cut.radius, other);
    if (twice != cut.last_twice) {
        cut.last_twice = twice;
        cut.last_reach = chord_reach(cut.dx, metric_squared(twice));
    }
    return cut.last_reach;
}

// Blocks what the sample, seen at height y, takes of the `around` points to either side. Only words
// with free points count, and of those only the runs of pixels that hold them.
void block(inout Cut cut, const int y, const int around) {
    const int low = max(y - around + 1, 0);
    const int high = min(y + around, int(g.height));
    if (low >= high) return;
    const u32 begin = u32(low);
    const u32 end = u32(high);
    for (u32 word = begin / 32u; word <= (end - 1u) / 32u; ++word) {
        const u32 index = cut.line_begin + word;
        u32 open = bits[index] & word_mask(word, begin, end);
        u32 mask = 0u;
        while (open != 0u) {
            const u32 at = word * 32u + u32(findLSB(open));
            const u32 row = row_of[at];
            const u32 run_end = min(row_begins[row + 1u], word * 32u + 32u);
            const u32 run = open & word_mask(word, at, run_end);
            open ^= run;
            const int reach = int(reach_to(cut, pixel_radii[cut.pixel_begin + row]));
            const int from = max(int(at), y - reach + 1);
            const int to = min(int(run_end), y + reach);
            if (from < to) mask |= run & word_mask(word, u32(from), u32(to));
        }
        // Invocations may clear one word at a time: what was still set tells each what it has
        // blocked.
        if (mask != 0u) cut.blocked += count_bits(atomicAnd(bits[index], ~mask) & mask);
    }
}

// Whether a point of [begin, end) may be free: of few or many words, some may.
bool any_set(const u32 line_begin, const u32 begin, const u32 end) {
    if (end - begin > MOST_LOOKS * 32u) return true;
    for (u32 word = begin / 32u; word * 32u < end; ++word)
        if ((bits[line_begin + word] & word_mask(word, begin, end)) != 0u) return true;
    return false;
}

// How far from the sample's height a free point of the line can be that it blocks, plus 1; 0 if
// none. With min no farther than its radius. With mean and max the widest pixels reach farthest,
// and they are the first to be blocked. Invocations look side by side: wherever widest[line]
// stands, no wider row has a free point.
int half_chord(const Cut cut, const u32 reach, const u32 line) {
    u64 limit = reach;
    limit = limit * limit + 1u;
    u64 dx_squared = cut.dx;
    dx_squared = dx_squared * dx_squared;
    if (dx_squared >= limit) return 0;
    if (!is_far_reach(metric, reach, cut.radius)) return int(chord_reach(cut.dx, limit));

    // Pass over pixels without a free point until one has some, or all that are left are too small.
    const u32 first = widest[line];
    u32 i = first;
    for (u32 looks = 0u; i < rows && looks < MOST_LOOKS; ++i) {
        const u32 row = widest_rows[cut.pixel_begin + i];
        const u32 bound = class_bound(pixel_radii[cut.pixel_begin + row]);
        limit = min(limit, metric_squared(twice_metric_radius(metric, cut.radius, bound)));
        const u32 begin = row_begins[row];
        const u32 end = row_begins[row + 1u];
        if (dx_squared >= limit || any_set(cut.line_begin, begin, end)) break;
        looks += (end - begin) / 32u + 1u;
    }
    if (i > first) atomicMax(widest[line], i);
    return i == rows ? 0 : int(chord_reach(cut.dx, limit));
}

void main() {
    if (undecided[last_pass] != 0u) return;
    const u32 item = first_item + gl_GlobalInvocationID.x;
    if (item / slices >= count) return;
    const u32 i = is_listed != 0u ? todo[item / slices] : item / slices;
    if (fates[i] != FATE_ADMITTED) return;
    const uvec4 a_sample = candidates[i];
    const u32 pixel = column_of[a_sample.x] * rows + row_of[a_sample.y];
    const u32 radius = pixel_radii[pixel];
    const u32 reach = pixel_reaches[pixel];
    if (reach > most_reach) {
        if (item % slices == 0u) left[atomicAdd(left_count, 1u)] = i;
        return;
    }
    const Stretch near = near_lines(a_sample.x, reach, g.lines, g.period_x);
    for (u32 k = item % slices; k < near.count; k += slices) {
        const u32 line = (near.first + k) % g.lines;
        const u32 dx = axis_distance(a_sample.x, line, g.period_x);
        Cut cut = {radius, dx, line * words, column_of[line] * rows, 0u, 0u, 0u};
        const int around = half_chord(cut, reach, line);
        const int y = int(a_sample.y);
        const int period = int(g.period_y);
        for (int shift = -period; shift <= period; shift += max(period, 1))
            block(cut, y + shift, around);
        if (cut.blocked != 0u) atomicAdd(free_lengths[line], 0u - cut.blocked);
    }
    if (!has_turns_left(g.height)) atomicOr(failure, FAILED_SUBTRACT);
}
