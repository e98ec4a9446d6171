// The neighbour index where radii differ: for each block of first boxes (plan/first_boxes.h) the
// list of the samples that reach it, from the latest to the first. See grid.h for the other index.
#include "bodies/exact/radius_field.h"
#include "bodies/exact/strip.h"
#include "portable/conflict.h"

// The number of the first entry of the list of a box's block.
struct Near {
    u32 first;
};
LACUNA_TYPEDEF(Near)

// Goes through the samples near a box: the number of the next entry.
struct Walk {
    u32 number;
};
LACUNA_TYPEDEF(Walk)

BODY Strip strip_with(const u32x4 at, const u32 radius) {
    Strip strip = {at, radius & ~IS_EVEN, (radius & IS_EVEN) != 0u};
    if (radius == 0u) strip.at.w = strip.at.z;
    return strip;
}

// A box where no sample may lie, which only looking up its radius has shown, stays until it is
// halved.
BODY Strip box_at(MEMORY const StripArguments a, const u32 number) {
    const u32 radius = AT(origins, number).y;
    const Strip box = {AT(boxes, number), radius & ~IS_EVEN, (radius & IS_EVEN) != 0u};
    return box;
}

BODY u32 strips_of(const StripArguments a, const Strip box) {
    if (a.strip_bits == 0u) return 1u;
    return box.is_even ? 2u : 4u;
}

// Half k of a box on like pixels. Of the others, strip k of the left half, below and above a border
// of pixels, and then of the right half: split has found the borders.
BODY Strip strip_of(MEMORY const StripArguments a, const u32 number, const Strip box, const u32 k) {
    if (a.strip_bits == 0u) return box;
    Strip strip = box;
    if (box.is_even) {
        strip.at = half_of(box.at, k);
        return strip;
    }
    const u32x4 cuts = AT(borders, number);
    const u32 x = cuts.x == 0u ? box.at.x + box.at.y : cuts.x;
    const u32 up = k < 2u ? cuts.y : cuts.z;
    const u32 y = up == 0u ? box.at.w : up;
    strip.at.x = k < 2u ? box.at.x : x;
    strip.at.y = (k < 2u ? x : box.at.x + box.at.y) - strip.at.x;
    strip.at.z = k % 2u == 0u ? box.at.z : y;
    strip.at.w = k % 2u == 0u ? y : box.at.w;
    if (strip.at.y == 0u) strip.at.w = strip.at.z;
    if (is_empty(strip)) return strip;
    const Grids grids = {grid_of(ON COLUMNS_OF_FIELD), grid_of(ON COLUMNS_OF_MASK)};
    return strip_with(strip.at, radius_under(under(ON grids, touched_by(grids, strip.at))));
}

BODY Near near_of(MEMORY const StripArguments a, const u32 number, const Strip box) {
    const Near near = {AT(lists, AT(origins, number).x)};
    return near;
}

BODY Walk walk_over(const StripArguments a, const Near near) {
    const Walk walk = {near.first};
    return walk;
}

// Entries before first_recent have been taken out of the box already.
BODY bool has_sample(const StripArguments a, const Walk walk) {
    return walk.number != NO_SAMPLE && walk.number >= a.first_recent;
}

// x, y, radius, and the number of the next entry.
BODY u32x4 sample_at(MEMORY const StripArguments a, const Near near, const Walk walk) {
    return AT(entries, walk.number);
}

BODY Walk walk_past(const Walk walk, const u32x4 neighbour) {
    const Walk next = {neighbour.w};
    return next;
}

// What a new box needs besides where it lies: its block, and the least radius under it. That is the
// strip's where the box is all of the strip, or the strip lies on like pixels; elsewhere it is
// looked up. Looking it up for a strip on like pixels could find unlike ones beside it.
BODY void keep_origin(MEMORY const u32 from, const Strip strip, const u32x4 box, const u32 to) {
    u32 radius = strip.is_even ? strip.radius | IS_EVEN : strip.radius;
    if (!strip.is_even && (box.z != strip.at.z || box.w != strip.at.w)) {
        const Grids grids = {grid_of(ON COLUMNS_OF_FIELD), grid_of(ON COLUMNS_OF_MASK)};
        radius = radius_under(under(ON grids, touched_by(grids, box)));
    }
    AT(new_origins, to) = U32X2(AT(origins, from).x, radius);
}
