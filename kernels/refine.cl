// refine: what all samples leave of the places, in boxes (DESIGN section 4, "exact").
#include "portable/sample_grid.h"
#include "portable/chord.h"
#include "portable/column.h"
#include "portable/distance.h"
#include "portable/failure.h"
#include "portable/fate.h"
#include "portable/geometry.h"

// Puts the round's samples into their cells. Does nothing while admission is unsettled
// (undecided[last_pass] != 0).
kernel void insert(const Geometry g, const u32 last_pass, const u32 draw_count, const u32 chunk,
                   global const u32* restrict undecided, global const uint4* restrict candidates,
                   global const u32* restrict fates, global u32* restrict grid_x,
                   global u32* restrict grid_y) {
    if (undecided[last_pass] != 0u) return;
    const u32 begin = (u32)get_global_id(0) * chunk;
    const u32 end = min(begin + chunk, draw_count);
    for (u32 i = begin; i < end; ++i) {
        if (fates[i] != FATE_ADMITTED) continue;
        const uint4 sample = candidates[i];
        const u32 cell = sample.x / g.grid_side * g.grid_rows + sample.y / g.grid_side;
        grid_x[cell] = sample.x;
        grid_y[cell] = sample.y;
    }
}

// Counts the boxes of the lines [first_line, end_line), whose free spans are cut where rows of
// cells end: counts[line]. With writes != 0 writes them, where scan has found their places to be.
kernel void unfold(const Geometry g, const u32 first_line, const u32 end_line, const u32 writes,
                   const u32 block, global const uint2* restrict spans,
                   global const u32* restrict span_counts, global u32* restrict counts,
                   global const u32* restrict sums, global u32* restrict box_x,
                   global u32* restrict box_begin, global u32* restrict box_end,
                   volatile global u32* failure) {
    const u32 line = first_line + (u32)get_global_id(0);
    if (line >= end_line) return;
    if (line + 1u == g.lines && writes == 0u) counts[g.lines] = 0u;
    const u64 slot = (u64)(line - first_line) * g.capacity;
    u32 place = writes != 0u ? counts[line] + sums[line / block] : 0u;
    for (u32 i = 0u; i < span_counts[line]; ++i) {
        const uint2 span = spans[slot + i];
        if (writes == 0u) {
            place += (span.y - 1u) / g.grid_side - span.x / g.grid_side + 1u;
            continue;
        }
        for (u32 begin = span.x; begin < span.y; begin = box_end[place - 1u]) {
            box_x[place] = line * g.strip_width;
            box_begin[place] = begin;
            box_end[place] = begin + min(span.y - begin, g.grid_side - begin % g.grid_side);
            ++place;
        }
    }
    if (writes == 0u) counts[line] = place;
    if (!has_turns_left(g.height)) atomic_or(failure, FAILED_REFINE);
}

// There is at most one sample a cell, and a box and a radius around it reach over at most 7 x 6
// cells, those at the seam of a torus counted twice.
#define MOST_NEAR 64u

// The samples near a box.
typedef struct Near {
    u32 count;
    u32 x[MOST_NEAR + 1u];
    u32 y[MOST_NEAR + 1u];
} Near;

void find_near(const Geometry g, const u32 x, const u32 x_end, const u32 begin, const u32 end,
               global const u32* restrict grid_x, global const u32* restrict grid_y,
               Near* near) {
    const u32 x_windows = g.period_x != 0u ? 3u : 1u;
    const u32 y_windows = g.period_y != 0u ? 3u : 1u;
    u32 count = 0u;
    for (u32 i = 0u; i < x_windows; ++i) {
        const u32 column_low = near_low(i, x, x_end, g.radius, g.width, g.grid_side);
        const u32 column_high = near_high(i, x, x_end, g.radius, g.width, g.grid_side);
        if (column_low > column_high) continue;
        for (u32 j = 0u; j < y_windows; ++j) {
            const u32 row_low = near_low(j, begin, end, g.radius, g.height, g.grid_side);
            const u32 row_high = near_high(j, begin, end, g.radius, g.height, g.grid_side);
            for (u32 column = column_low; column <= column_high; ++column) {
                // Every cell is written, and kept or not: no branch.
                for (u32 row = row_low; row <= row_high; ++row) {
                    const u32 cell = column * g.grid_rows + row;
                    near->x[count] = grid_x[cell];
                    near->y[count] = grid_y[cell];
                    count = min(count + (grid_x[cell] != NO_SAMPLE ? 1u : 0u), MOST_NEAR);
                }
            }
        }
    }
    near->count = count;
}

// What the samples near take from a strip, sorted by where it begins; then one chord at its end.
typedef struct Chords {
    u32 count;
    u32 begin[MOST_NEAR + 3u];
    u32 end[MOST_NEAR + 3u];
} Chords;

void add_chord(const u32 begin, const u32 end, Chords* chords) {
    u32 to = chords->count;
    while (to > 0u && begin < chords->begin[to - 1u]) {
        chords->begin[to] = chords->begin[to - 1u];
        chords->end[to] = chords->end[to - 1u];
        --to;
    }
    chords->begin[to] = begin;
    chords->end[to] = end;
    ++chords->count;
}

// On a torus, what sticks out at one end is cut at the other.
void add_wrapped_chords(const Geometry g, const u32 centre, const u32 margin, const u32 begin,
                        const u32 end, const Near* near, Chords* chords) {
    u32 bottom = 0u;
    u32 top = g.height;
    for (u32 i = 0u; i < near->count; ++i) {
        const u32 dx = axis_distance(near->x[i], centre, g.period_x) + margin;
        const u32 reach = chord_reach(dx, g.radius_squared);
        bottom = max(bottom, chord_wrapped_end(near->y[i], reach, g.height));
        top = min(top, chord_wrapped_begin(near->y[i], reach, g.height));
    }
    if (bottom > begin) add_chord(0u, bottom, chords);
    if (top < end) add_chord(top, g.height, chords);
}

// The chords of a strip of width 2 * margin, or 1, around centre. False when one sample covers the
// strip: most are, and most samples near leave a strip alone. Both show in squared distances, and
// only what is left takes a square root.
bool find_chords(const Geometry g, const u32 centre, const u32 margin, const u32 begin,
                 const u32 end, const Near* near, Chords* chords) {
    const u32 last = end - 1u;
    u32 touching[MOST_NEAR];
    u32 count = 0u;
    bool covered = false;
    for (u32 i = 0u; i < near->count; ++i) {
        const u32 y = near->y[i];
        const u32 dx = axis_distance(near->x[i], centre, g.period_x) + margin;
        const u32 closest = max(begin > y ? begin - y : 0u, y > last ? y - last : 0u);
        const u32 farthest = max(last > y ? last - y : 0u, y > begin ? y - begin : 0u);
        covered = covered | (squared_length(dx, farthest) < g.radius_squared);
        touching[count] = i;
        count += squared_length(dx, closest) < g.radius_squared ? 1u : 0u;
    }
    if (covered) return false;

    chords->count = 0u;
    for (u32 i = 0u; i < count; ++i) {
        const u32 y = near->y[touching[i]];
        const u32 dx = axis_distance(near->x[touching[i]], centre, g.period_x) + margin;
        const u32 reach = chord_reach(dx, g.radius_squared);
        add_chord(chord_begin(y, reach), chord_end(y, reach, g.height), chords);
    }
    if (g.period_y != 0u && (begin < g.radius || end + g.radius > g.height))
        add_wrapped_chords(g, centre, margin, begin, end, near, chords);
    add_chord(end, end, chords);
    return true;
}

// A piece [begin, end) that the chords leave of a strip, and where to look for the next.
typedef struct Piece {
    u32 begin;
    u32 end;
    u32 chord;
    u32 free_from;
} Piece;

// Finds the next piece, at first with begin, end and chord 0 and free_from at the strip's begin.
bool find_piece(const Chords* chords, Piece* piece) {
    while (piece->chord < chords->count) {
        const u32 i = piece->chord;
        piece->begin = piece->free_from;
        piece->end = chords->begin[i];
        piece->free_from = max(piece->free_from, chords->end[i]);
        ++piece->chord;
        if (piece->begin < piece->end) return true;
    }
    return false;
}

// Cuts each box, `parts` times as wide as what becomes of it, in its strips: counts[strip] is the
// number of pieces that are left of one, and piece_begin, piece_end hold the first.
kernel void cut(const Geometry g, const u32 boxes, const u32 chunk, const u32 width,
                const u32 parts, global const u32* restrict box_x,
                global const u32* restrict box_begin, global const u32* restrict box_end,
                global const u32* restrict grid_x, global const u32* restrict grid_y,
                global u32* restrict counts, global u32* restrict piece_begin,
                global u32* restrict piece_end, volatile global u32* failure) {
    const u32 first_box = (u32)get_global_id(0) * chunk;
    const u32 end_box = min(first_box + chunk, boxes);
    Near near;
    Chords chords;
    for (u32 box = first_box; box < end_box; ++box) {
        const u32 x = box_x[box];
        const u32 begin = box_begin[box];
        const u32 end = box_end[box];
        find_near(g, x, x + width * parts, begin, end, grid_x, grid_y, &near);
        if (near.count == MOST_NEAR) atomic_or(failure, FAILED_CHORDS);
        for (u32 part = 0u; part < parts; ++part) {
            const u32 strip = box * parts + part;
            const u32 centre = x + part * width + width / 2u;
            u32 count = 0u;
            if (find_chords(g, centre, width / 2u, begin, end, &near, &chords)) {
                Piece piece = {0u, 0u, 0u, begin};
                for (; find_piece(&chords, &piece); ++count) {
                    if (count > 0u) continue;
                    piece_begin[strip] = piece.begin;
                    piece_end[strip] = piece.end;
                }
            }
            counts[strip] = count;
        }
        if (box + 1u == boxes) counts[boxes * parts] = 0u;
    }
    if (!has_turns_left(g.height)) atomic_or(failure, FAILED_REFINE);
}

// Replaces the values of each block by the sums of those before them in the block; the sum of the
// whole goes to sums[].
kernel void scan(const u32 count, const u32 block, global u32* restrict values,
                 global u32* restrict sums, volatile global u32* failure) {
    const u32 item = (u32)get_global_id(0);
    const u32 begin = item * block;
    const u32 end = min(begin + block, count);
    if (begin >= end) return;
    u32 sum = 0u;
    for (u32 i = begin; i < end; ++i) {
        const u32 value = values[i];
        values[i] = sum;
        sum += value;
    }
    sums[item] = sum;
    if (!has_turns_left(sum)) atomic_or(failure, FAILED_REFINE);
}

// Writes the pieces to their places: where there is one of a strip, the one that cut has found;
// strips with several are cut again.
kernel void keep(const Geometry g, const u32 boxes, const u32 chunk, const u32 width,
                 const u32 parts, const u32 block, global const u32* restrict box_x,
                 global const u32* restrict box_begin, global const u32* restrict box_end,
                 global const u32* restrict grid_x, global const u32* restrict grid_y,
                 global const u32* restrict counts, global const u32* restrict sums,
                 global const u32* restrict piece_begin, global const u32* restrict piece_end,
                 global u32* restrict new_x, global u32* restrict new_begin,
                 global u32* restrict new_end, global u32* restrict free_lengths,
                 volatile global u32* failure) {
    const u32 first_strip = (u32)get_global_id(0) * chunk;
    const u32 end_strip = min(first_strip + chunk, boxes * parts);
    Near near;
    Chords chords;
    for (u32 strip = first_strip; strip < end_strip; ++strip) {
        u32 place = counts[strip] + sums[strip / block];
        const u32 end_place = counts[strip + 1u] + sums[(strip + 1u) / block];
        if (place == end_place) continue;
        const u32 box = strip / parts;
        const u32 x = box_x[box] + strip % parts * width;
        Piece piece = {piece_begin[strip], piece_end[strip], 0u, box_begin[box]};
        if (place + 1u < end_place) {
            find_near(g, x, x + width, box_begin[box], box_end[box], grid_x, grid_y, &near);
            find_chords(g, x + width / 2u, width / 2u, box_begin[box], box_end[box], &near,
                        &chords);
            find_piece(&chords, &piece);
        }
        while (true) {
            new_x[place] = x;
            new_begin[place] = piece.begin;
            new_end[place] = piece.end;
            free_lengths[place] = piece.end - piece.begin;
            ++place;
            if (place == end_place) break;
            find_piece(&chords, &piece);
        }
    }
    if (!has_turns_left(g.height)) atomic_or(failure, FAILED_REFINE);
}

// The first box of each column: the first whose line is not below the column's first. That of
// column `columns` is the number of boxes.
kernel void find_place_begins(const Geometry g, const u32 boxes, global const u32* restrict box_x,
                              global u32* restrict place_begins) {
    const u32 column = (u32)get_global_id(0);
    if (column > g.columns) return;
    const u32 line = first_line_of_column(column, g.lines, g.columns);
    u32 begin = 0u;
    u32 end = boxes;
    while (begin < end) {
        const u32 middle = begin + (end - begin) / 2u;
        if (box_x[middle] / g.strip_width < line)
            begin = middle + 1u;
        else
            end = middle;
    }
    place_begins[column] = begin;
}
