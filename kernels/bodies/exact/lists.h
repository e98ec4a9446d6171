// The neighbour index where radii differ: for each block of first boxes (plan/first_boxes.h) a list
// of the samples that reach it, the latest first. The other index is grid.h.
#include "bodies/exact/ellipses.h"
#include "bodies/exact/strip.h"
#include "portable/conflict.h"
#include "portable/radius_field.h"

// Numbers of four entries, in the order of the list from its end: `a` was found last.
struct Four {
    u32 a;
    u32 b;
    u32 c;
    u32 d;
};
LACUNA_TYPEDEF(Four)

BODY Four put_before(const u32 number, const Four rest) {
    const Four four = {number, rest.a, rest.b, rest.c};
    return four;
}

// The samples that may cut a box: the numbers of their entries in the list, if there are at most
// MOST_NEAR. If there are more, a walk visits all entries of the list from `first`.
#define MOST_NEAR 8u
struct Near {
    u32 first;
    u32 count;
    Four latest;
    Four earlier;
};
LACUNA_TYPEDEF(Near)

// A walk through the samples near a box: how many remain, and the number of the next entry.
struct Walk {
    u32 left;
    u32 number;
};
LACUNA_TYPEDEF(Walk)

// If measure finds that no sample may lie in a box, the box stays until it is halved.
BODY HalvedBox box_at(MEMORY const StripArguments a, const u32 number) {
    const u32 radius = LOAD(Origin, origins, number).radius;
    const Strip whole = {LOAD(Box, boxes, number), radius & ~IS_EVEN, (radius & IS_EVEN) != 0u};
    HalvedBox box = uncut(whole);
    if (a.strip_bits != 0u && !whole.is_even) {
        box.borders = LOAD(Borders, borders, number);
        box.radii = LOAD(StripRadii, strip_radii, number);
    }
    return box;
}

BODY u32 radius_of_strip(const StripRadii radii, const bool is_left, const bool is_below) {
    if (is_left) return is_below ? radii.left_below : radii.left_above;
    return is_below ? radii.right_below : radii.right_above;
}

BODY u32 nth_of(const Four four, const u32 k) {
    return k < 2u ? (k == 0u ? four.a : four.b) : (k == 2u ? four.c : four.d);
}

// Strip k of a box. A box on like pixels has two, its halves, and no strips 2 and 3. A box on
// unlike pixels has four, below and above a border of pixels: two in the left half, two in the
// right.
BODY Strip strip_of(const StripArguments a, const HalvedBox box, const u32 k) {
    Strip strip = box.whole;
    if (a.strip_bits == 0u) return strip;
    const Box whole = strip.at;
    if (strip.is_even) {
        strip.at = half_of(whole, k);
        if (k > 1u) strip.at.end = strip.at.begin;
        return strip;
    }
    const bool is_left = k < 2u;
    const bool is_below = k % 2u == 0u;
    const u32 radius = radius_of_strip(box.radii, is_left, is_below);
    const u32 x = box.borders.x;
    const u32 y = is_left ? box.borders.left_y : box.borders.right_y;
    strip.at.x = is_left ? whole.x : x;
    strip.at.width = (is_left ? x : whole.x + whole.width) - strip.at.x;
    strip.at.begin = is_below ? whole.begin : y;
    strip.at.end = radius == 0u ? strip.at.begin : (is_below ? y : whole.end);
    strip.radius = radius & ~IS_EVEN;
    strip.is_even = (radius & IS_EVEN) != 0u;
    return strip;
}

// Entries before first_recent have cut the box already.
BODY bool is_in_list(const StripArguments a, const u32 number) {
    return number != NO_SAMPLE && number >= a.first_recent;
}

// The greatest radius of a box's strips: no chord is of a larger radius.
BODY u32 greatest_radius(const StripArguments a, const HalvedBox box) {
    if (a.strip_bits == 0u || box.whole.is_even) return box.whole.radius;
    return max(max(box.radii.left_below & ~IS_EVEN, box.radii.left_above & ~IS_EVEN),
               max(box.radii.right_below & ~IS_EVEN, box.radii.right_above & ~IS_EVEN));
}

// The least distance in x of a sample from the far edges of the box's strips. Where a box is halved
// in its middle, no far edge is nearer than the middle, less 1 unit where halves are one unit wide.
// Strips of a box on unlike pixels may lie anywhere in it.
BODY u32 least_distance(const StripArguments a, const Strip box, const u32 x) {
    const u32 to_middle = axis_distance(x, box.at.x + box.at.width / 2u, a.g.period_x);
    const u32 to_box = distance_to_stretch(x, box.at.x, box.at.x + box.at.width, a.g.period_x);
    return box.is_even ? to_middle - min(to_middle, 1u) : to_box;
}

// A neighbour's x on the copy of the strip, and the square of the distance that it keeps there.
BODY u32 x_of(const StripArguments a, const Neighbour neighbour, const Strip strip) {
    return x_beside(neighbour.x, strip.at.x, a.g.copy_bits);
}
BODY u64 limit_near(MEMORY const StripArguments a, const Neighbour neighbour, const Strip strip) {
    return squared_limit(neighbour.radius, strip.radius,
                         factor_of(ON a.g, neighbour.x, strip.at.x));
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
                            const Neighbour neighbour) {
    Ellipse of_strip;
    if (strip.is_even)
        of_strip = ellipse_at(ON strip.at.x, strip.at.begin);
    else
        of_strip = circle_of(strip.radius);
    const Interval found = ellipse_chord(neighbour.x, ellipse_at(ON neighbour.x, neighbour.y),
                                         strip.at.x, strip.at.width, of_strip, a.g.period_x);
    const i64 y = to_i64(neighbour.y);
    const Interval none = {0, 0};
    const Interval heights = {y + found.begin, y + found.end};
    Chord chord = {neighbour.y, 0u, none};
    if (found.begin < found.end) chord.heights = heights;
    return chord;
}

BODY Chord chord_of(MEMORY const StripArguments a, const Strip strip, const Neighbour neighbour) {
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
BODY Near near_of(MEMORY const StripArguments a, const u32 number, const HalvedBox box) {
    Strip whole = box.whole;
    whole.radius = greatest_radius(a, box);
    const Four none = {0u, 0u, 0u, 0u};
    Near near = {AT(lists, LOAD(Origin, origins, number).block), 0u, none, none};
    u32 next = near.first;
    while (is_in_list(a, next)) {
        const Neighbour entry = LOAD(Neighbour, entries, next);
        const u32 dx = least_distance(a, whole, x_of(a, entry, whole));
        const u32 dy = distance_to_stretch(entry.y, whole.at.begin, whole.at.end, a.g.period_y);
        if (squared_length(dx, dy) < limit_near(ON a, entry, whole)) {
            near.earlier = put_before(near.latest.d, near.earlier);
            near.latest = put_before(next, near.latest);
            ++near.count;
        }
        next = entry.next;
    }
    return near;
}

BODY Walk walk_over(const StripArguments a, const Near near) {
    const Walk walk = {near.count, near.count > MOST_NEAR ? near.first : near.latest.a};
    return walk;
}

BODY bool has_sample(const StripArguments a, const Near near, const Walk walk) {
    return near.count > MOST_NEAR ? is_in_list(a, walk.number) : walk.left != 0u;
}

BODY Neighbour sample_at(MEMORY const StripArguments a, const Near near, const Walk walk) {
    return LOAD(Neighbour, entries, walk.number);
}

BODY Walk walk_past(const Near near, const Walk walk, const Neighbour neighbour) {
    Walk next = {walk.left - 1u, neighbour.next};
    if (near.count > MOST_NEAR) return next;
    const u32 index = near.count - next.left;
    next.number = index < 4u ? nth_of(near.latest, index) : nth_of(near.earlier, index - 4u);
    return next;
}

// A new box's block, and the least radius under it. The radius is the strip's where the box is all
// of the strip, or the strip lies on like pixels; elsewhere it is 0, and measure looks it up.
BODY void keep_origin(MEMORY const u32 from, const Strip strip, const Box box, const u32 to) {
    const bool is_whole = box.begin == strip.at.begin && box.end == strip.at.end;
    const u32 radius = strip.is_even ? strip.radius | IS_EVEN : is_whole ? strip.radius : 0u;
    const Origin origin = {LOAD(Origin, origins, from).block, radius};
    STORE(new_origins, to, origin);
}
