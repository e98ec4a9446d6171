// The strips of a place with a radius field: itself or, where places are halved, its left and its
// right half. Most places lie on pixels that are all alike. Of each of the others there are four,
// which split finds: the parts of its left half below and above a border of pixels, and then those
// of its right half.
#include "portable/radius_field.h"

struct Strip {
    u32x4 at;    // empty where a place has no such strip, or no sample may go there
    u32 radius;  // the least under it, perhaps with IS_EVEN
};
LACUNA_TYPEDEF(Strip)

// In the end of what cut_halves leaves of a half: a part inside is missing.
#define IS_CUT_INSIDE 0x80000000u

BODY u32 radius_of(const Strip strip) {
    return strip.radius & ~IS_EVEN;
}

BODY bool is_empty(const Strip strip) {
    return strip.at.z == strip.at.w;
}

BODY bool is_even(const u32 radius) {
    return (radius & IS_EVEN) != 0u;
}

BODY Strip whole_strip(const u32x4 place, const u32 radius) {
    const Strip strip = {place, radius};
    return strip;
}

// All of a place one unit wide.
BODY Strip left_half(const u32x4 place, const u32 radius) {
    Strip strip = {place, radius};
    strip.at.y = max(place.y / 2u, 1u);
    return strip;
}

BODY Strip right_half(const u32x4 place, const u32 radius) {
    const u32 left = max(place.y / 2u, 1u);
    Strip strip = {place, radius};
    strip.at.x = place.x + left;
    strip.at.y = place.y - left;
    if (place.y == left) strip.at.w = place.z;
    return strip;
}
