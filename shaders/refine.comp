// refine: what all samples leave of the places, in boxes (DESIGN section 4, "exact"). Longer than
// other files because cut and keep share most of their text.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#include "portable/sample_grid.h"
#include "portable/chord.h"
#include "portable/column.h"
#include "portable/distance.h"
#include "portable/failure.h"
#include "portable/fate.h"
#include "portable/geometry.h"

#define i64 int64_t

layout(local_size_x_id = 0) in;

#ifdef ENTRY_insert
// Puts the round's samples into their cells. Does nothing while admission is unsettled
// (undecided[last_pass] != 0).
layout(push_constant) uniform Arguments { u32 first_item; Geometry g; u32 draw_count;
                                          u32 last_pass; };
layout(binding = 0) readonly restrict buffer Undecided { u32 undecided[]; };
layout(binding = 1) readonly restrict buffer Candidates { uvec4 candidates[]; };
layout(binding = 2) readonly restrict buffer Fates { u32 fates[]; };
layout(binding = 3) writeonly restrict buffer GridX { u32 grid_x[]; };
layout(binding = 4) writeonly restrict buffer GridY { u32 grid_y[]; };

void main() {
    const u32 i = first_item + gl_GlobalInvocationID.x;
    if (i >= draw_count || undecided[last_pass] != 0u || fates[i] != FATE_ADMITTED) return;
    const uvec2 at = candidates[i].xy;
    const u32 cell = at.x / g.grid_side * g.grid_rows + at.y / g.grid_side;
    grid_x[cell] = at.x;
    grid_y[cell] = at.y;
}
#endif

#ifdef ENTRY_unfold
// At the first refinement: the free spans of the lines [first_line, end_line), cut where a row of
// cells ends, become boxes as wide as the strips. First only their number is asked for, which goes
// to counts[line]; then, with prefix sums in its place (see scan), they are written.
layout(push_constant) uniform Arguments { u32 first_item; Geometry g; u32 first_line;
                                          u32 end_line; u32 block; u32 is_counting; };
layout(binding = 0) readonly restrict buffer Spans { uvec2 spans[]; };
layout(binding = 1) readonly restrict buffer SpanCounts { u32 span_counts[]; };
layout(binding = 2) restrict buffer Counts { u32 counts[]; };
layout(binding = 3) readonly restrict buffer Sums { u32 sums[]; };
layout(binding = 4) writeonly restrict buffer BoxX { u32 box_x[]; };
layout(binding = 5) writeonly restrict buffer BoxBegin { u32 box_begin[]; };
layout(binding = 6) writeonly restrict buffer BoxEnd { u32 box_end[]; };
layout(binding = 7) coherent restrict buffer Failure { u32 failure; };

void main() {
    const u32 line = first_line + first_item + gl_GlobalInvocationID.x;
    if (line >= end_line) return;
    const u32 slot = (line - first_line) * g.capacity;
    const u32 span_count = span_counts[line];
    u32 next = is_counting != 0u ? 0u : counts[line] + sums[line / block];
    for (u32 i = 0u; i < span_count; ++i) {
        const uvec2 span = spans[slot + i];
        if (is_counting != 0u) {
            next += (span.y - 1u) / g.grid_side - span.x / g.grid_side + 1u;
            continue;
        }
        u32 begin = span.x;
        while (begin < span.y) {
            const u32 end = min(span.y, begin - begin % g.grid_side + g.grid_side);
            box_x[next] = line * g.strip_width;
            box_begin[next] = begin;
            box_end[next] = end;
            ++next;
            begin = end;
        }
    }
    if (is_counting != 0u) counts[line] = next;
    if (!has_turns_left(g.height)) atomicOr(failure, FAILED_REFINE);
}
#endif

#if defined(ENTRY_cut) || defined(ENTRY_keep)
#ifdef ENTRY_cut
// Cuts the strips of all boxes by all samples near them: each box is a strip, or, if is_halved, two
// of half its width. counts[strip] is how many pieces are left of one, and
// [piece_begin, piece_end) the piece where there is one; an end of 0 tells of none, NO_SAMPLE of
// several. Does nothing while admission is unsettled.
layout(push_constant) uniform Arguments { u32 first_item; Geometry g; u32 strip_count;
                                          u32 is_halved; u32 width; u32 last_pass; };
layout(binding = 0) readonly restrict buffer Undecided { u32 undecided[]; };
layout(binding = 1) readonly restrict buffer GridX { u32 grid_x[]; };
layout(binding = 2) readonly restrict buffer GridY { u32 grid_y[]; };
layout(binding = 3) readonly restrict buffer BoxX { u32 box_x[]; };
layout(binding = 4) readonly restrict buffer BoxBegin { u32 box_begin[]; };
layout(binding = 5) readonly restrict buffer BoxEnd { u32 box_end[]; };
layout(binding = 6) writeonly restrict buffer Counts { u32 counts[]; };
layout(binding = 7) writeonly restrict buffer PieceBegin { u32 piece_begin[]; };
layout(binding = 8) writeonly restrict buffer PieceEnd { u32 piece_end[]; };
layout(binding = 9) coherent restrict buffer Failure { u32 failure; };
#else
// Writes what cut left to the new boxes: a strip's pieces from counts[strip] + sums[strip / block]
// on. Only a strip with several is cut once more. What does not fit into `room` is left out.
layout(push_constant) uniform Arguments { u32 first_item; Geometry g; u32 strip_count;
                                          u32 is_halved; u32 width; u32 last_pass; u32 block;
                                          u32 room; };
layout(binding = 0) readonly restrict buffer Undecided { u32 undecided[]; };
layout(binding = 1) readonly restrict buffer GridX { u32 grid_x[]; };
layout(binding = 2) readonly restrict buffer GridY { u32 grid_y[]; };
layout(binding = 3) readonly restrict buffer BoxX { u32 box_x[]; };
layout(binding = 4) readonly restrict buffer BoxBegin { u32 box_begin[]; };
layout(binding = 5) readonly restrict buffer BoxEnd { u32 box_end[]; };
layout(binding = 6) readonly restrict buffer Counts { u32 counts[]; };
layout(binding = 7) readonly restrict buffer PieceBegin { u32 piece_begin[]; };
layout(binding = 8) readonly restrict buffer PieceEnd { u32 piece_end[]; };
layout(binding = 9) readonly restrict buffer Sums { u32 sums[]; };
layout(binding = 10) writeonly restrict buffer NewX { u32 new_x[]; };
layout(binding = 11) writeonly restrict buffer NewBegin { u32 new_begin[]; };
layout(binding = 12) writeonly restrict buffer NewEnd { u32 new_end[]; };
layout(binding = 13) writeonly restrict buffer Lengths { u32 lengths[]; };
layout(binding = 14) coherent restrict buffer Failure { u32 failure; };
#endif

// [x, x + width) times [begin, end).
struct Strip {
    u32 x;
    u32 begin;
    u32 end;
};

Strip strip_at(const u32 index) {
    const u32 box = index >> is_halved;
    return Strip(box_x[box] + (index & is_halved) * width, box_begin[box], box_end[box]);
}

// A box and a radius around it reach over at most 7 x 6 cells: a bit each, 8 to a column.
const u32 kMostNear = 8u;

// What the chords leave of a strip: [low, high), less those inside it, which may overlap. Most
// chords cover one of its ends.
struct Rest {
    u32 low;
    u32 high;
    u32 inside_count;
};
const u32 kMostInside = 64u;
uvec2 inside[kMostInside];

// Around a torus each sample has three images. Only at the edges do others count than itself.
i64 first_image(const Strip strip) {
    const bool is_at_edge = strip.begin < g.radius || g.height - strip.end < g.radius;
    return g.period_y != 0u && is_at_edge ? -1 : 0;
}

u64 square(const u32 a) {
    return u64(a) * u64(a);
}

// A chord covers a strip's whole width: it is cut at the far edge.
u32 far_distance(const u32 x, const Strip strip) {
    return axis_distance(x, strip.x + width / 2u, g.period_x) + width / 2u;
}

// Takes a chord out; its ends may lie outside the domain.
void take(const i64 begin, const i64 end, inout Rest rest) {
    if (end <= rest.low || begin >= rest.high) return;
    if (begin <= rest.low) {
        rest.low = u32(min(end, i64(rest.high)));
    } else if (end >= rest.high) {
        rest.high = u32(begin);
    } else if (rest.inside_count < kMostInside) {
        inside[rest.inside_count] = uvec2(u32(begin), u32(end));
        ++rest.inside_count;
    } else {
        atomicOr(failure, FAILED_CHORDS);
    }
}

// The cells near a strip, and the first image of the samples in them that counts.
struct Near {
    GridStretch columns;
    GridStretch rows;
    i64 first_image;
};

Near near_to(const Strip strip) {
    Near near;
    near.columns = grid_stretch(strip.x, strip.x + width, g.radius, g.width, g.period_x, g.grid_side,
                              g.grid_columns);
    near.rows = grid_stretch(strip.begin, strip.end, g.radius, g.height, g.period_y, g.grid_side,
                           g.grid_rows);
    near.first_image = first_image(strip);
    if (max(near.columns.count, near.rows.count) > kMostNear) atomicOr(failure, FAILED_CHORDS);
    return near;
}

u32 cell_at(const Near near, const u32 i, const u32 j) {
    return nth_of_stretch(near.columns, i, g.grid_columns) * g.grid_rows +
           nth_of_stretch(near.rows, j, g.grid_rows);
}

// The cells whose samples touch the strip, a bit each; none if one sample covers it. Most strips
// are covered by one, and most samples near leave a strip alone: both show in squared distances.
// No branch, as in screen.
uvec2 find_touching(const Strip strip, const Near near, out bool is_covered) {
    uvec2 touching = uvec2(0u, 0u);
    is_covered = false;
    for (i64 image = near.first_image; image <= -near.first_image; ++image) {
        const i64 begin = strip.begin - image * g.height;
        const i64 last = begin + (strip.end - strip.begin) - 1;
        for (u32 i = 0u; i < near.columns.count; ++i) {
            for (u32 j = 0u; j < near.rows.count; ++j) {
                const u32 cell = cell_at(near, i, j);
                const u32 x = grid_x[cell];
                const i64 y = grid_y[cell];
                const u32 dx = far_distance(x, strip);
                const u64 left = g.radius_squared - square(dx);
                const bool reaches = x != NO_SAMPLE && dx < g.radius;
                const i64 below = begin - y;
                const i64 above = y - last;
                const u32 closest = u32(max(max(below, above), i64(0)));
                const u32 farthest = u32(max(-below, -above));
                is_covered = is_covered || (reaches && square(farthest) < left);
                const bool touches = reaches && square(closest) < left;
                const u32 bit = touches ? 1u << (i % 4u * kMostNear + j) : 0u;
                touching |= i < 4u ? uvec2(bit, 0u) : uvec2(0u, bit);
            }
        }
    }
    return is_covered ? uvec2(0u, 0u) : touching;
}

// Only here roots are taken.
Rest cut_strip(const Strip strip) {
    const Near near = near_to(strip);
    bool is_covered;
    uvec2 touching = find_touching(strip, near, is_covered);
    Rest rest = Rest(strip.begin, is_covered ? strip.begin : strip.end, 0u);
    while ((touching.x | touching.y) != 0u) {
        // Take the lowest bit.
        const bool is_first = touching.x != 0u;
        const u32 bit = u32(findLSB(is_first ? touching.x : touching.y));
        if (is_first)
            touching.x &= touching.x - 1u;
        else
            touching.y &= touching.y - 1u;

        const u32 cell = cell_at(near, bit / kMostNear + (is_first ? 0u : 4u), bit % kMostNear);
        const i64 reach = chord_reach(far_distance(grid_x[cell], strip), g.radius_squared);
        for (i64 image = near.first_image; image <= -near.first_image; ++image) {
            const i64 y = grid_y[cell] + image * g.height;
            take(y - reach + 1, y + reach, rest);
        }
    }
    return rest;
}

// Finds the lowest piece of the rest that begins at `from` or above, and moves `from` to its end.
bool find_piece(const Rest rest, inout u32 from, out uvec2 piece) {
    while (from < rest.high) {
        u32 covered_to = from;
        u32 next = rest.high;
        for (u32 i = 0u; i < rest.inside_count; ++i) {
            const uvec2 chord = inside[i];
            if (chord.x <= from)
                covered_to = max(covered_to, chord.y);
            else
                next = min(next, chord.x);
        }
        piece = uvec2(from, next);
        if (covered_to == from) {
            from = next;
            return true;
        }
        from = covered_to;
    }
    return false;
}
#endif

#ifdef ENTRY_cut
void main() {
    const u32 index = first_item + gl_GlobalInvocationID.x;
    if (index >= strip_count || undecided[last_pass] != 0u) return;
    const Rest rest = cut_strip(strip_at(index));

    u32 count = 0u;
    uvec2 first = uvec2(0u, 0u);
    u32 from = rest.low;
    uvec2 piece;
    while (find_piece(rest, from, piece)) {
        if (count == 0u) first = piece;
        ++count;
    }
    counts[index] = count;
    piece_begin[index] = first.x;
    piece_end[index] = count > 1u ? NO_SAMPLE : first.y;
    if (!has_turns_left(g.height)) atomicOr(failure, FAILED_REFINE);
}
#endif

#ifdef ENTRY_scan
// Prefix sums within blocks: each of the values becomes the sum of those before it in its block,
// and sums[block] that of all of them.
layout(push_constant) uniform Arguments { u32 first_item; u32 value_count; u32 block; };
layout(binding = 0) restrict buffer Values { u32 values[]; };
layout(binding = 1) writeonly restrict buffer Sums { u32 sums[]; };
layout(binding = 2) coherent restrict buffer Failure { u32 failure; };

void main() {
    const u32 index = first_item + gl_GlobalInvocationID.x;
    const u32 begin = index * block;
    if (begin >= value_count) return;
    const u32 end = begin + min(block, value_count - begin);
    u32 sum = 0u;
    for (u32 i = begin; i < end; ++i) {
        const u32 value = values[i];
        values[i] = sum;
        sum += value;
    }
    sums[index] = sum;
    if (!has_turns_left(value_count)) atomicOr(failure, FAILED_REFINE);
}
#endif

#ifdef ENTRY_keep
void keep_piece(const u32 x, const uvec2 piece, const u32 place) {
    if (place >= room) return;
    new_x[place] = x;
    new_begin[place] = piece.x;
    new_end[place] = piece.y;
    lengths[place] = piece.y - piece.x;
}

void main() {
    const u32 index = first_item + gl_GlobalInvocationID.x;
    if (index >= strip_count || undecided[last_pass] != 0u) return;
    const u32 end = piece_end[index];
    if (end == 0u) return;
    const Strip strip = strip_at(index);
    u32 place = counts[index] + sums[index / block];
    if (end != NO_SAMPLE) {
        keep_piece(strip.x, uvec2(piece_begin[index], end), place);
        return;
    }
    const Rest rest = cut_strip(strip);
    u32 from = rest.low;
    uvec2 piece;
    while (find_piece(rest, from, piece)) {
        keep_piece(strip.x, piece, place);
        ++place;
    }
    if (!has_turns_left(g.height)) atomicOr(failure, FAILED_REFINE);
}
#endif

#ifdef ENTRY_find_place_begins
// The first box of each column, and at last the number of boxes, which come line by line.
layout(push_constant) uniform Arguments { u32 first_item; Geometry g; u32 room; };
layout(binding = 0) readonly restrict buffer BoxX { u32 box_x[]; };
layout(binding = 1) readonly restrict buffer BoxCount { u32 box_count; };
layout(binding = 2) writeonly restrict buffer PlaceBegins { u32 place_begins[]; };

void main() {
    const u32 column = first_item + gl_GlobalInvocationID.x;
    if (column > g.columns) return;
    const u32 first_line = first_line_of_column(column, g.lines, g.columns);
    u32 begin = 0u;
    u32 end = min(box_count, room);
    while (begin < end) {
        const u32 middle = begin + (end - begin) / 2u;
        if (box_x[middle] / g.strip_width < first_line)
            begin = middle + 1u;
        else
            end = middle;
    }
    place_begins[column] = begin;
}
#endif
