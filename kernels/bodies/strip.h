// The strips of a place on a ground: itself or, where places are halved, four, the parts of its
// left half below and above a border of pixels, and then those of its right half. Most places lie
// on pixels that are all alike: they have halves alone, and those need no table. Of others split
// fills one.
#include "portable/ground.h"

struct Strip {
    u32x4 at;    // empty where a place has no such strip, or no sample may go there
    u32 radius;  // the least under it, perhaps with IS_EVEN
};
LACUNA_TYPEDEF(Strip)

BODY u32 strips_of_place(const bool is_halved) {
    return is_halved ? 4u : 1u;
}

BODY u32 radius_of(const Strip strip) {
    return strip.radius & ~IS_EVEN;
}

BODY bool is_empty(const Strip strip) {
    return strip.at.z == strip.at.w;
}

BODY Strip strip_at(const u32x4 at, const u32 radius, const bool is_there) {
    Strip strip = {at, is_there ? radius : 0u};
    if (!is_there) strip.at.w = at.z;
    return strip;
}

// Strip k of a place with this radius under it.
BODY Strip strip_of(MEMORY const bool is_halved, const u32 number, const u32x4 place,
                    const u32 radius, const u32 k) {
    if (!is_halved) return strip_at(place, radius, k == 0u);
    const u32 left = place.y / 2u;
    u32x4 half_place = place;
    if (k >= 2u) {
        half_place.x = place.x + left;
        half_place.y = place.y - left;
    } else if (left != 0u) {
        half_place.y = left;
    }
    Strip strip = strip_at(half_place, radius, k == 0u || (k == 2u && left != 0u));
    if ((radius & IS_EVEN) == 0u) {
        strip.at = AT(strips, number * 4u + k);
        strip.radius = AT(strip_radii, number * 4u + k);
    }
    return strip;
}
