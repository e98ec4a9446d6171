// A tree of boxes around near sites, each with the least weight in it. It finds the sites that can
// win a leaf of 8 x 8 lattice points (docs/design.md, section 9).
//
// Level 0 is the sites, in an order in which near sites are near each other. Node i of level 1, 2,
// ... has the children 8 i .. 8 i + 7 of the level below, as far as they exist. Level `depth` has
// one node, the root. Levels are stored from the root down, each with memory for 8 times as many
// nodes as the level above it.
#ifndef LACUNA_PORTABLE_SITE_TREE_H
#define LACUNA_PORTABLE_SITE_TREE_H
#include "types.h"

LACUNA_BEGIN

#define LEAF_SIDE 8u

// Devices store a 64-bit number as two words, the lower one first.
LACUNA_FN u64 join_words(u32 low, u32 high) {
    u64 wide = high;
    return wide << 32 | low;
}

// A node or site; `begin` is the index at which its level begins.
struct Cursor {
    u32 level;
    u32 index;
    u32 begin;
};
LACUNA_TYPEDEF(Cursor)

LACUNA_FN u32 nodes_of_level(u32 samples, u32 level) {
    u32 least = (1u << (3u * level)) - 1u;
    return (samples + least) >> (3u * level);
}

// The first child.
LACUNA_FN Cursor below_cursor(Cursor at) {
    Cursor to;
    to.level = at.level - 1u;
    to.index = at.index * 8u;
    to.begin = at.begin * 8u + 1u;
    return to;
}

// The next node that is no child. If there is none, it lies beyond the root, on level depth + 1.
LACUNA_FN Cursor next_cursor(Cursor at, u32 samples, u32 depth) {
    Cursor to = at;
    while (to.level <= depth &&
           ((to.index & 7u) == 7u || to.index + 1u == nodes_of_level(samples, to.level))) {
        to.level = to.level + 1u;
        to.index = to.index / 8u;
        to.begin = (to.begin - 1u) / 8u;
    }
    to.index = to.index + 1u;
    return to;
}

// The first child, or the next node that is no child.
LACUNA_FN Cursor step_cursor(Cursor at, bool is_down, u32 samples, u32 depth) {
    Cursor below = below_cursor(at);
    Cursor to = next_cursor(at, samples, depth);
    to.level = is_down ? below.level : to.level;
    to.index = is_down ? below.index : to.index;
    to.begin = is_down ? below.begin : to.begin;
    return to;
}

// A rectangle, both ends included. Signed: seen from an image of the domain it may lie outside.
struct Rect {
    i32 left;
    i32 bottom;
    i32 right;
    i32 top;
};
LACUNA_TYPEDEF(Rect)

LACUNA_FN u32 interval_gap(i32 low, i32 high, i32 begin, i32 last) {
    i32 gap = begin - high > low - last ? begin - high : low - last;
    return gap > 0 ? to_u32(gap) : 0u;
}

LACUNA_FN u32 farther_end(i32 at, i32 begin, i32 last) {
    i32 far = at - begin > last - at ? at - begin : last - at;
    return to_u32(far);
}

// The least power that a site inside `low` .. `high`, with a weight of at least `weight`, has
// anywhere in the box.
LACUNA_FN u64 least_power(i32 low_x, i32 low_y, i32 high_x, i32 high_y, u64 weight, Rect box) {
    u64 dx = interval_gap(low_x, high_x, box.left, box.right);
    u64 dy = interval_gap(low_y, high_y, box.bottom, box.top);
    return dx * dx + dy * dy + weight;
}

// The power of a site in the box's worst corner.
LACUNA_FN u64 worst_power(i32 x, i32 y, u64 weight, Rect box) {
    u64 dx = farther_end(x, box.left, box.right);
    u64 dy = farther_end(y, box.bottom, box.top);
    return dx * dx + dy * dy + weight;
}

// A site that may win a leaf. (dx, dy) is its position relative to the leaf's lowest lattice point.
// Its power minus |p|^2 at lattice point (u, v) is at - 2 (u step_x dx + v step_y dy). The
// difference of two rivals is exact and contains no square.
struct Rival {
    i64 at;
    i32 dx;
    i32 dy;
};
LACUNA_TYPEDEF(Rival)

// `at` is below 2^63 if the power in the leaf is below 2^62.
LACUNA_FN Rival rival_of(i32 dx, i32 dy, u64 weight) {
    i64 x = dx;
    i64 y = dy;
    Rival rival;
    rival.at = x * x + y * y + to_i64(weight);
    rival.dx = dx;
    rival.dy = dy;
    return rival;
}

// How far a rival is behind another: at + u along_x + v along_y in lattice point (u, v). May be
// negative.
struct Lag {
    i64 at;
    i64 along_x;
    i64 along_y;
};
LACUNA_TYPEDEF(Lag)

LACUNA_FN Lag lag_of(Rival rival, Rival other, u32 step_x, u32 step_y) {
    i64 x = rival.dx;
    i64 y = rival.dy;
    i64 wide_x = step_x;
    i64 wide_y = step_y;
    Lag lag;
    lag.at = rival.at - other.at;
    lag.along_x = (x - other.dx) * wide_x * -2;
    lag.along_y = (y - other.dy) * wide_y * -2;
    return lag;
}

// Whether the lag stays below 2^29 in all lattice points up to (most, most). Then 32 bits hold it,
// and also the difference of two lags whose terms are taken at different points.
LACUNA_FN bool is_short(Lag lag, u32 most) {
    i64 limit = 1 << 29;
    i64 at = lag.at < 0 ? -lag.at : lag.at;
    i64 along_x = lag.along_x < 0 ? -lag.along_x : lag.along_x;
    i64 along_y = lag.along_y < 0 ? -lag.along_y : lag.along_y;
    i64 wide = most;
    return at < limit && (along_x + along_y) * wide < limit - at;
}

// Whether `rival` beats or equals `other` somewhere in a leaf of this size in units, from first to
// last lattice points. The difference is largest in a corner.
LACUNA_FN bool can_win(Rival rival, Rival other, u32 width, u32 height) {
    u64 x = rival.dx > other.dx ? to_u32(rival.dx) - to_u32(other.dx) : 0u;
    u64 y = rival.dy > other.dy ? to_u32(rival.dy) - to_u32(other.dy) : 0u;
    u64 wins = x * width + y * height;
    return rival.at - other.at <= to_i64(wins * 2u);
}

// The moment that a mass of 1 at the leaf's lowest lattice point on an axis, `low`, adds: see
// moment_offset in power.h. `image` is 0 for a period below, 1 for the site itself, 2 for a period
// above. The result may wrap; the sums that contain it do not.
LACUNA_FN u64 leaf_offset(u32 low, u32 at, u32 step, u32 count, u32 image) {
    u64 offset = low + count - at / step;
    u64 period = count;
    return offset + period - period * image;
}

LACUNA_END

#endif
