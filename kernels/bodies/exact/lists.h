// The neighbour index where radii differ: for each block of first boxes (plan/first_boxes.h) a list
// of the samples that reach it, the latest first. The other index is grid.h.
#include "bodies/exact/ellipses.h"
#include "bodies/exact/strip.h"
#include "portable/conflict.h"
#include "portable/radius_field.h"

// The samples that may cut a box: the numbers of their entries in the list, if there are at most
// MOST_NEAR. If there are more, a walk visits all entries of the list from `first`.
#define MOST_NEAR 8u
struct Near {
    u32 first;
    u32 count;
    u32x4 low;   // the last four numbers found, the very last in x
    u32x4 high;  // the four before
};
LACUNA_TYPEDEF(Near)

// A walk through the samples near a box: how many remain, and the number of the next entry.
struct Walk {
    u32 left;
    u32 number;
};
LACUNA_TYPEDEF(Walk)

// If measure finds that no sample may lie in a box, the box stays until it is halved.
BODY Box box_at(MEMORY const StripArguments a, const u32 number) {
    const u32 radius = AT(origins, number).y;
    const Strip whole = {AT(boxes, number), radius & ~IS_EVEN, (radius & IS_EVEN) != 0u};
    Box box = {whole, U32X4(0u, 0u, 0u, 0u), U32X4(0u, 0u, 0u, 0u)};
    if (a.strip_bits != 0u && !whole.is_even) {
        box.borders = AT(borders, number);
        box.radii = AT(strip_radii, number);
    }
    return box;
}

BODY u32 component(const u32x4 words, const u32 k) {
    return k < 2u ? (k == 0u ? words.x : words.y) : (k == 2u ? words.z : words.w);
}

// Strip k of a box. A box on like pixels has two, its halves, and no strips 2 and 3. A box on
// unlike pixels has four, below and above a border of pixels: two in the left half, two in the
// right.
BODY Strip strip_of(const StripArguments a, const Box box, const u32 k) {
    Strip strip = box.whole;
    if (a.strip_bits == 0u) return strip;
    const u32x4 whole = strip.at;
    if (strip.is_even) {
        strip.at = half_of(whole, k);
        if (k > 1u) strip.at.w = strip.at.z;
        return strip;
    }
    const u32 radius = component(box.radii, k);
    const u32 x = box.borders.x;
    const u32 y = k < 2u ? box.borders.y : box.borders.z;
    strip.at.x = k < 2u ? whole.x : x;
    strip.at.y = (k < 2u ? x : whole.x + whole.y) - strip.at.x;
    strip.at.z = k % 2u == 0u ? whole.z : y;
    strip.at.w = radius == 0u ? strip.at.z : (k % 2u == 0u ? y : whole.w);
    strip.radius = radius & ~IS_EVEN;
    strip.is_even = (radius & IS_EVEN) != 0u;
    return strip;
}

// Entries before first_recent have cut the box already.
BODY bool is_in_list(const StripArguments a, const u32 number) {
    return number != NO_SAMPLE && number >= a.first_recent;
}

// The greatest radius of a box's strips: no chord is of a larger radius.
BODY u32 greatest_radius(const StripArguments a, const Box box) {
    if (a.strip_bits == 0u || box.whole.is_even) return box.whole.radius;
    return max(max(box.radii.x & ~IS_EVEN, box.radii.y & ~IS_EVEN),
               max(box.radii.z & ~IS_EVEN, box.radii.w & ~IS_EVEN));
}

// The least distance in x of a sample from the far edges of the box's strips. Where a box is halved
// in its middle, no far edge is nearer than the middle, less 1 unit where halves are one unit wide.
// Strips of a box on unlike pixels may lie anywhere in it.
BODY u32 least_distance(const StripArguments a, const Strip box, const u32 x) {
    const u32 to_middle = axis_distance(x, box.at.x + box.at.y / 2u, a.g.period_x);
    const u32 to_box = distance_to_stretch(x, box.at.x, box.at.x + box.at.y, a.g.period_x);
    return box.is_even ? to_middle - min(to_middle, 1u) : to_box;
}

// A neighbour's x on the sheet of the strip, and the square of the distance that it keeps there.
BODY u32 x_of(const StripArguments a, const u32x4 neighbour, const Strip strip) {
    return x_beside(neighbour.x, strip.at.x, a.g.sheet_bits);
}
BODY u64 limit_near(MEMORY const StripArguments a, const u32x4 neighbour, const Strip strip) {
    return squared_limit(neighbour.z, strip.radius, factor_of(ON a.g, neighbour.x, strip.at.x));
}

// The part of the strip's whole width that a sample takes: as far up as down from its height or,
// with ellipses, the heights themselves.
struct Chord {
    u32 y;
    u32 reach;
    Interval heights;
};
LACUNA_TYPEDEF(Chord)

BODY Chord chord_of_ellipse(MEMORY const StripArguments a, const Strip strip,
                            const u32x4 neighbour) {
    Ellipse of_strip;
    if (strip.is_even)
        of_strip = ellipse_at(ON strip.at.x, strip.at.z);
    else
        of_strip = circle_of(strip.radius);
    const Interval found = ellipse_chord(neighbour.x, ellipse_at(ON neighbour.x, neighbour.y),
                                         strip.at.x, strip.at.y, of_strip, a.g.period_x);
    const i64 y = to_i64(neighbour.y);
    const Interval none = {0, 0};
    const Interval heights = {y + found.begin, y + found.end};
    Chord chord = {neighbour.y, 0u, none};
    if (found.begin < found.end) chord.heights = heights;
    return chord;
}

BODY Chord chord_of(MEMORY const StripArguments a, const Strip strip, const u32x4 neighbour) {
    if (a.g.rule == RULE_OF_ELLIPSES) return chord_of_ellipse(ON a, strip, neighbour);
    const u32 dx = cut_distance(a.g, strip, x_of(a, neighbour, strip));
    const Interval none = {0, 0};
    const Chord chord = {neighbour.y, chord_reach(dx, limit_near(ON a, neighbour, strip)), none};
    return chord;
}
BODY u32 begin_of_chord(const Geometry g, const Chord chord, const u32 window) {
    if (g.rule == RULE_OF_ELLIPSES) return height_in_window(window, chord.heights.begin, g.height);
    return window_begin(window, chord.y, chord.reach, g.height);
}
BODY u32 end_of_chord(const Geometry g, const Chord chord, const u32 window) {
    if (g.rule == RULE_OF_ELLIPSES) return height_in_window(window, chord.heights.end, g.height);
    return window_end(window, chord.y, chord.reach, g.height);
}

// Walks along the list once.
BODY Near near_of(MEMORY const StripArguments a, const u32 number, const Box box) {
    Strip whole = box.whole;
    whole.radius = greatest_radius(a, box);
    Near near = {AT(lists, AT(origins, number).x), 0u, U32X4(0u, 0u, 0u, 0u),
                 U32X4(0u, 0u, 0u, 0u)};
    u32 next = near.first;
    while (is_in_list(a, next)) {
        const u32x4 entry = AT(entries, next);
        const u32 dx = least_distance(a, whole, x_of(a, entry, whole));
        const u32 dy = distance_to_stretch(entry.y, whole.at.z, whole.at.w, a.g.period_y);
        if (squared_length(dx, dy) < limit_near(ON a, entry, whole)) {
            near.high = U32X4(near.low.w, near.high.x, near.high.y, near.high.z);
            near.low = U32X4(next, near.low.x, near.low.y, near.low.z);
            ++near.count;
        }
        next = entry.w;
    }
    return near;
}

BODY Walk walk_over(const StripArguments a, const Near near) {
    const Walk walk = {near.count, near.count > MOST_NEAR ? near.first : near.low.x};
    return walk;
}

BODY bool has_sample(const StripArguments a, const Near near, const Walk walk) {
    return near.count > MOST_NEAR ? is_in_list(a, walk.number) : walk.left != 0u;
}

// x, y, radius, and the number of the next entry.
BODY u32x4 sample_at(MEMORY const StripArguments a, const Near near, const Walk walk) {
    return AT(entries, walk.number);
}

BODY Walk walk_past(const Near near, const Walk walk, const u32x4 neighbour) {
    Walk next = {walk.left - 1u, neighbour.w};
    if (near.count > MOST_NEAR) return next;
    const u32 index = near.count - next.left;
    next.number = index < 4u ? component(near.low, index) : component(near.high, index - 4u);
    return next;
}

// A new box's block, and the least radius under it. The radius is the strip's where the box is all
// of the strip, or the strip lies on like pixels; elsewhere it is 0, and measure looks it up.
BODY void keep_origin(MEMORY const u32 from, const Strip strip, const u32x4 box, const u32 to) {
    const bool is_whole = box.z == strip.at.z && box.w == strip.at.w;
    const u32 radius = strip.is_even ? strip.radius | IS_EVEN : is_whole ? strip.radius : 0u;
    AT(new_origins, to) = U32X2(AT(origins, from).x, radius);
}
