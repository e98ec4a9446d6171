// An active box on a device, and the strips that refine divides it into before it cuts chords.
//
// A box that is not halved is one strip. A halved box is two strips, its left and its right half.
// With a radius field, a halved box on unlike pixels is up to four: each half is divided along y,
// too, where a border of pixels runs through it.
#include "portable/distance.h"

struct Strip {
    Box at;        // empty (begin == end) where no sample may lie
    u32 radius;    // the least radius under it; that of a circle which lies in all ellipses
    bool is_even;  // whether all of it allows samples, and has this radius; or one ellipse, which
                   // lies in a circle of this radius
};
LACUNA_TYPEDEF(Strip)

struct HalvedBox {
    Strip whole;
    // With a radius field, if the box lies on unlike pixels and is halved: what split has found.
    Borders borders;
    StripRadii radii;
};
LACUNA_TYPEDEF(HalvedBox)

BODY HalvedBox uncut(const Strip whole) {
    HalvedBox box;
    box.whole = whole;
    const Borders no_borders = {0u, 0u, 0u, 0u};
    const StripRadii no_radii = {0u, 0u, 0u, 0u};
    box.borders = no_borders;
    box.radii = no_radii;
    return box;
}

// Half k of a box. The left half of a box that is one unit wide is the whole box.
BODY Box half_of(const Box box, const u32 k) {
    const u32 left = max(box.width / 2u, 1u);
    Box part = box;
    part.x = k == 0u ? box.x : box.x + left;
    part.width = k == 0u ? left : box.width - left;
    part.end = part.width == 0u ? box.begin : box.end;
    return part;
}

// A chord covers the strip's whole width, so it is cut at the far edge of the strip.
BODY u32 cut_distance(const Geometry g, const Strip strip, const u32 x) {
    const u32 middle = strip.at.width / 2u;
    return axis_distance(x, strip.at.x + middle, g.period_x) + middle;
}
