// The body of subtract in mode cells: clears the lattice points that the round's samples block, by
// the two-way check of section 4.2.
#include "portable/bits.h"
#include "portable/chord.h"
#include "portable/column.h"
#include "portable/distance.h"
#include "portable/metric.h"

// One sample and one line.
struct Cut {
    u32 radius;
    u32 dx;
    u32 line;
    u32 pixel_begin;  // index of the first pixel of the line
};
LACUNA_TYPEDEF(Cut)

// The heights in [begin, end), all under one pixel, that a sample at height y blocks. Mostly these
// are all or none, which squared distances show without a root.
BODY Span blocked_of_run(const u32 metric, const Cut cut, const u32 pixel, const i64 y,
                         const u32 begin, const u32 end) {
    const u64 limit = metric_squared(twice_metric_radius(metric, cut.radius, pixel));
    const u32 farthest = farthest_distance(y, to_i64(begin), to_i64(end));
    const u32 nearest = nearest_distance(y, to_i64(begin), to_i64(end));
    if (squared_length(cut.dx, farthest) < limit) return span_of(begin, end);
    if (squared_length(cut.dx, nearest) >= limit) return span_of(end, end);
    const i64 reach = to_i64(chord_reach(cut.dx, limit));
    return span_of(to_u32(max(to_i64(begin), y - reach + 1)), to_u32(min(to_i64(end), y + reach)));
}

// Blocks the points within `chord` of height y that the sample takes, and returns their number. It
// looks only at words with free points, and only at the runs of pixels in them.
BODY u32 block_points(MEMORY const DrawArguments a, const Cut cut, const i64 y, const u32 chord) {
    const i64 low = max(y - to_i64(chord) + 1, to_i64(0));
    const i64 high = min(y + to_i64(chord), to_i64(a.g.height));
    if (low >= high) return 0u;
    const u32 begin = to_u32(low);
    const u32 end = to_u32(high);
    u32 blocked = 0u;
    for (u32 word = begin / 32u; word <= (end - 1u) / 32u; ++word) {
        const u32 index = cut.line * a.g.capacity + word;
        u32 open = LOOK_AT(bits, index) & word_mask(word, begin, end);
        u32 mask = 0u;
        while (open != 0u) {
            const u32 first = word * 32u + lowest_bit(open);
            const u32 row = AT(row_of, first);
            const u32 run_end = min(AT(row_begins, row + 1u), word * 32u + 32u);
            const u32 run = open & word_mask(word, first, run_end);
            open = open ^ run;
            const Span taken = blocked_of_run(a.metric, cut, AT(pixel_radii, cut.pixel_begin + row),
                                              y, first, run_end);
            if (taken.begin < taken.end)
                mask = mask | (run & word_mask(word, taken.begin, taken.end));
        }
        // Several items may clear one word at a time. Each counts the bits that were still set.
        if (mask != 0u) blocked += count_bits(ATOMIC_AND(bits, index, ~mask) & mask);
    }
    return blocked;
}

// Whether a point of [begin, end) may be free. True without a search of more than MOST_LOOKS words.
BODY bool any_set(MEMORY const DrawArguments a, const u32 line, const u32 begin, const u32 end) {
    if (end - begin > MOST_LOOKS * 32u) return true;
    for (u32 word = begin / 32u; word * 32u < end; ++word)
        if ((LOOK_AT(bits, line * a.g.capacity + word) & word_mask(word, begin, end)) != 0u)
            return true;
    return false;
}

// The largest distance from the sample's height at which it can block a free point of the line,
// plus 1; 0 if there is none. With min that is limited by its radius. With mean and max the pixels
// of largest radius reach farthest, and are blocked first. Items may change widest[line] at the
// same time: whatever it holds, no row before it has a free point.
BODY u32 half_chord(MEMORY const DrawArguments a, const Cut cut, const u32 reach) {
    u64 limit = reach;
    limit = limit * limit + 1u;
    u64 dx_squared = cut.dx;
    dx_squared = dx_squared * dx_squared;
    if (dx_squared >= limit) return 0u;
    if (!is_far_reach(a.metric, reach, cut.radius)) return chord_reach(cut.dx, limit);

    // Skip pixels without a free point, until one has some or the others are too small.
    const u32 first = LOOK_AT(widest, cut.line);
    u32 i = first;
    for (u32 looks = 0u; i < a.rows && looks < MOST_LOOKS; ++i) {
        const u32 row = AT(widest_rows, cut.pixel_begin + i);
        const u32 bound = class_bound(AT(pixel_radii, cut.pixel_begin + row));
        limit = min(limit, metric_squared(twice_metric_radius(a.metric, cut.radius, bound)));
        const u32 begin = AT(row_begins, row);
        const u32 end = AT(row_begins, row + 1u);
        if (dx_squared >= limit || any_set(ON a, cut.line, begin, end)) break;
        looks += (end - begin) / 32u + 1u;
    }
    if (i > first) ATOMIC_MAX(widest, cut.line, i);
    return i == a.rows ? 0u : chord_reach(cut.dx, limit);
}

// Serves one slice of the lines near a sample.
BODY void serve_sample(MEMORY const DrawArguments a, const Candidate admitted, const u32 pixel,
                       const u32 slice) {
    const u32 reach = AT(pixel_reaches, pixel);
    const Stretch lines = stretch_around(admitted.x, reach, a.g.lines, a.g.period_x);
    for (u32 k = slice; k < lines.count; k += a.slices) {
        const u32 line = nth_of_stretch(lines, k, a.g.lines);
        Cut cut = {AT(pixel_radii, pixel), axis_distance(admitted.x, line, a.g.period_x), line,
                   AT(column_of, line) * a.rows};
        const u32 chord = half_chord(ON a, cut, reach);
        if (chord == 0u) continue;
        u32 blocked = 0u;
        const i64 first_image = to_i64(a.g.period_y != 0u ? -1 : 0);
        for (i64 image = first_image; image <= -first_image; ++image)
            blocked +=
                block_points(ON a, cut, to_i64(admitted.y) + image * to_i64(a.g.height), chord);
        if (blocked != 0u) ATOMIC_ADD(free_lengths, line, 0u - blocked);
    }
}

// Serves one slice, every slices-th line, of the lines near each sample of a chunk of candidates. A
// sample that reaches farther than most_reach would take too many turns: it is listed in `left`,
// and the next launch takes it from `todo` with more slices. Does nothing while admission is
// unfinished.
BODY void serve_subtract_in_cells(MEMORY const DrawArguments a, const u32 item) {
    if (AT(report, a.last_pass) != 0u) return;
    const u32 begin = a.first + item / a.slices * a.chunk;
    const u32 end = min(begin + a.chunk, a.count);
    for (u32 k = begin; k < end; ++k) {
        const u32 i = a.is_listed != 0u ? AT(todo, k) : k;
        if (AT(statuses, i) != STATUS_ADMITTED) continue;
        const Candidate admitted = LOAD(Candidate, candidates, i);
        const u32 pixel = AT(column_of, admitted.x) * a.rows + AT(row_of, admitted.y);
        if (AT(pixel_reaches, pixel) <= a.most_reach)
            serve_sample(ON a, admitted, pixel, item % a.slices);
        else if (item % a.slices == 0u)
            AT(left, ATOMIC_ADD(report, LEFT_WORD, 1u)) = i;
    }
    CHECK_TURNS(a.g.height, FAILED_SUBTRACT);
}
