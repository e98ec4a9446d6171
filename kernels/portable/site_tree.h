// The tree of boxes around sites that lie near each other, each with the least weight in it: which
// sites can win a leaf, 8 x 8 lattice points (docs/design.md, section 9).
//
// Sites come in an order in which neighbours are near each other: they are level 0. Node i of level
// 1, 2, ... has the children 8 i .. 8 i + 7 of the level below, as far as there are so many; level
// `depth` has one node, the root. From the root on each level is stored with room for 8 times as
// many nodes as the one above it.
#ifndef LACUNA_PORTABLE_SITE_TREE_H
#define LACUNA_PORTABLE_SITE_TREE_H
#include "prelude.h"

LACUNA_BEGIN

#define LEAF_SIDE 8u

// A number of 64 bits as devices keep it: two words, the lower first.
LACUNA_FN u64 join_words(u32 low, u32 high) {
    u64 wide = high;
    return wide << 32 | low;
}

// A node or site: `begin` is where its level is stored.
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

// The next that is no child: past the root, on level depth + 1, when there is none.
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

// Places, both ends included. Signed: an image of the domain sees them outside of itself.
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

// The least power that any site inside of `low` .. `high` with a weight of at least `weight` has
// anywhere in the box.
LACUNA_FN u64 least_power(i32 low_x, i32 low_y, i32 high_x, i32 high_y, u64 weight, Rect box) {
    u64 dx = interval_gap(low_x, high_x, box.left, box.right);
    u64 dy = interval_gap(low_y, high_y, box.bottom, box.top);
    return dx * dx + dy * dy + weight;
}

// The power that a site has in the box's worst corner.
LACUNA_FN u64 worst_power(i32 x, i32 y, u64 weight, Rect box) {
    u64 dx = farther_end(x, box.left, box.right);
    u64 dy = farther_end(y, box.bottom, box.top);
    return dx * dx + dy * dy + weight;
}

// A site that may win a leaf, (dx, dy) from its lowest lattice point: its power less |p|^2 at
// lattice point (u, v) is at - 2 (u step_x dx + v step_y dy). Of two rivals, the difference is
// exact, and no square is left.
struct Rival {
    i64 at;
    i32 dx;
    i32 dy;
};
LACUNA_TYPEDEF(Rival)

// `at` is below 2^63 for a power below 2^62 in the leaf.
LACUNA_FN Rival rival_of(i32 dx, i32 dy, u64 weight) {
    i64 x = dx;
    i64 y = dy;
    Rival rival;
    rival.at = x * x + y * y + to_i64(weight);
    rival.dx = dx;
    rival.dy = dy;
    return rival;
}

// By how much a rival is behind another, as a rule: in lattice point (u, v) at + u along_x + v
// along_y.
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

// Whether it stays below 2^29 in all lattice points up to (most, most): then 32 bits hold it there,
// and the difference of two, wherever in the area each of its two terms is.
LACUNA_FN bool is_short(Lag lag, u32 most) {
    i64 limit = 1 << 29;
    i64 at = lag.at < 0 ? -lag.at : lag.at;
    i64 along_x = lag.along_x < 0 ? -lag.along_x : lag.along_x;
    i64 along_y = lag.along_y < 0 ? -lag.along_y : lag.along_y;
    i64 wide = most;
    return at < limit && (along_x + along_y) * wide < limit - at;
}

// Whether `other` fails to beat `rival` somewhere in a leaf of this size in units, from its first
// to its last lattice points: where they differ most lies in a corner.
LACUNA_FN bool can_win(Rival rival, Rival other, u32 width, u32 height) {
    u64 x = rival.dx > other.dx ? to_u32(rival.dx) - to_u32(other.dx) : 0u;
    u64 y = rival.dy > other.dy ? to_u32(rival.dy) - to_u32(other.dy) : 0u;
    u64 wins = x * width + y * height;
    return rival.at - other.at <= to_i64(wins * 2u);
}

// What a mass at the leaf's lowest lattice point on an axis, `low`, adds to a moment: see
// moment_offset in power.h. The site's image `image` is 0, 1 or 2: a period below, the site itself,
// a period above. May wrap: only sums are more than 0.
LACUNA_FN u64 leaf_offset(u32 low, u32 at, u32 step, u32 count, u32 image) {
    u64 offset = low + count - at / step;
    u64 period = count;
    return offset + period - period * image;
}

LACUNA_END

#endif
