// An active box on a device, and the strips that refine divides it into before it cuts chords.
//
// A box that is not halved is one strip. A halved box is two strips, its left and its right half.
// With a radius field, a halved box on unlike pixels is up to four: each half is divided along y,
// too, where a border of pixels runs through it.
#include "portable/distance.h"

struct Strip {
    u32x4 at;      // x, width, begin, end; empty (begin == end) where no sample may lie
    u32 radius;    // the least radius under it; that of a circle which lies in all ellipses
    bool is_even;  // whether all of it allows samples, and has this radius; or one ellipse, which
                   // lies in a circle of this radius
};
LACUNA_TYPEDEF(Strip)

struct Box {
    Strip whole;
    // With a radius field, if the box lies on unlike pixels and is halved: what split has found.
    u32x4 borders;
    u32x4 radii;
};
LACUNA_TYPEDEF(Box)

// Half k of a box. The left half of a box that is one unit wide is the whole box.
BODY u32x4 half_of(const u32x4 box, const u32 k) {
    const u32 left = max(box.y / 2u, 1u);
    u32x4 part = box;
    part.x = k == 0u ? box.x : box.x + left;
    part.y = k == 0u ? left : box.y - left;
    part.w = part.y == 0u ? box.z : box.w;
    return part;
}

// A chord covers the strip's whole width, so it is cut at the far edge of the strip.
BODY u32 cut_distance(const Geometry g, const Strip strip, const u32 x) {
    const u32 middle = strip.at.y / 2u;
    return axis_distance(x, strip.at.x + middle, g.period_x) + middle;
}
