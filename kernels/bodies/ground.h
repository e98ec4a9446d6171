// The ground on a device: what radius each place asks for, and where samples may go
// (plan/ground.h).
// A rectangle is x, width, begin, end; one of pixels the first and last of its columns, and of its
// rows.
#include "portable/ground.h"

struct Under {
    u32 least;      // of the radii that are not 0; 0 where no sample may go
    bool is_mixed;  // the radii are
    u32 allowed;    // of the mask
};
LACUNA_TYPEDEF(Under)

// Values that stand column by column.
struct Level {
    u32 shift;  // a value is of 2^shift x 2^shift pixels
    u32 first;
    u32 rows;
};
LACUNA_TYPEDEF(Level)

BODY u32 axis_word(MEMORY const u32 axis, const u32 word) {
    return AT(axes, axis * AXIS_WORDS + word);
}

BODY u32 pixel_of(MEMORY const u32 axis, const u32 at) {
    return pixel_at(at, axis_word(ON axis, AXIS_SCALE), axis_word(ON axis, AXIS_SCALE + 1u),
                    axis_word(ON axis, AXIS_SHIFT));
}

// The pixels that a rectangle touches, of the axis of columns and the one of rows after it.
BODY u32x4 pixels_under(MEMORY const u32 columns, const u32x4 place) {
    return U32X4(pixel_of(ON columns, place.x), pixel_of(ON columns, place.x + place.y - 1u),
                 pixel_of(ON columns + 1u, place.z), pixel_of(ON columns + 1u, place.w - 1u));
}

// The lowest level of a pyramid of which a rectangle of pixels touches at most 4 x 4 values.
BODY Level level_over(MEMORY const u32 axis, const u32x4 pixels) {
    Level level = {0u, 0u, axis_word(ON axis + 1u, AXIS_PIXELS)};
    u32 columns = axis_word(ON axis, AXIS_PIXELS);
    while ((pixels.y >> level.shift) - (pixels.x >> level.shift) >= 4u ||
           (pixels.w >> level.shift) - (pixels.z >> level.shift) >= 4u) {
        level.first += columns * level.rows;
        columns = (columns + 1u) / 2u;
        level.rows = (level.rows + 1u) / 2u;
        ++level.shift;
    }
    return level;
}

// The least and the greatest, see portable/ground.h.
BODY u32x2 radii_over(MEMORY const u32x4 pixels) {
    const Level level = level_over(ON COLUMNS_OF_FIELD, pixels);
    u32x2 all = U32X2(0u, 0u);
    for (u32 i = pixels.x >> level.shift; i <= pixels.y >> level.shift; ++i) {
        for (u32 j = pixels.z >> level.shift; j <= pixels.w >> level.shift; ++j) {
            const u32x2 value = AT(radius_bounds, level.first + i * level.rows + j);
            all = U32X2(least_of_radii(all.x, value.x), greatest_of_radii(all.y, value.y));
        }
    }
    return all;
}

// Of value `number` of the mask's pyramid.
BODY u32 allowed_of(MEMORY const u32 number) {
    return AT(mask_bits, number / ALLOWED_PER_WORD) >> number % ALLOWED_PER_WORD * 2u & 3u;
}

BODY u32 allowed_over(MEMORY const u32x4 pixels) {
    const Level level = level_over(ON COLUMNS_OF_MASK, pixels);
    u32 seen = 0u;  // a bit for each value
    for (u32 i = pixels.x >> level.shift; i <= pixels.y >> level.shift; ++i) {
        for (u32 j = pixels.z >> level.shift; j <= pixels.w >> level.shift; ++j)
            seen = seen | 1u << allowed_of(ON level.first + i * level.rows + j);
    }
    if (seen == 1u << ALLOWED_NONE) return ALLOWED_NONE;
    return seen == 1u << ALLOWED_ALL ? ALLOWED_ALL : ALLOWED_SOME;
}

BODY Under under(MEMORY const u32x4 place) {
    const u32x2 radii = radii_over(ON pixels_under(ON COLUMNS_OF_FIELD, place));
    Under found = {radii.x, are_radii_mixed(radii.x, radii.y), ALLOWED_ALL};
    if (axis_word(ON COLUMNS_OF_MASK, AXIS_PIXELS) != 0u)
        found.allowed = allowed_over(ON pixels_under(ON COLUMNS_OF_MASK, place));
    if (found.allowed == ALLOWED_NONE) found.least = 0u;
    return found;
}

// The least radius, with IS_EVEN where there is no other; 0 where no sample may go.
BODY u32 radius_under(const Under all) {
    const bool is_even = all.least != 0u && !all.is_mixed && all.allowed == ALLOWED_ALL;
    return is_even ? all.least | IS_EVEN : all.least;
}

// 0 where no sample may go.
BODY u32 radius_at(MEMORY const u32 x, const u32 y) {
    const u32 row = pixel_of(ON ROWS_OF_FIELD, y);
    const u32 rows = axis_word(ON ROWS_OF_FIELD, AXIS_PIXELS);
    const u32 radius = AT(radius_bounds, pixel_of(ON COLUMNS_OF_FIELD, x) * rows + row).x;
    const u32 mask_rows = axis_word(ON ROWS_OF_MASK, AXIS_PIXELS);
    if (mask_rows == 0u) return radius;
    const u32 mask_row = pixel_of(ON ROWS_OF_MASK, y);
    const u32 allowed = allowed_of(ON pixel_of(ON COLUMNS_OF_MASK, x) * mask_rows + mask_row);
    return allowed == ALLOWED_NONE ? 0u : radius;
}

// Of the pixels that [begin, end) touches but for the first, where the one in the middle begins; 0
// where there is none.
BODY u32 middle_border(MEMORY const u32 axis, const u32 begin, const u32 end) {
    const u32 first = pixel_of(ON axis, begin);
    const u32 last = pixel_of(ON axis, end - 1u);
    if (first == last) return 0u;
    return AT(axes, axis_word(ON axis, AXIS_BEGINS) + first + (last - first + 1u) / 2u);
}

// Where to cut a place with this under it in two: along a border of pixels near its middle where it
// lies on unlike ones, or else, along x, in its middle. 0 where it is not to be cut.
BODY u32 cut_x(MEMORY const u32x4 place, const Under all) {
    const u32 end = place.x + place.y;
    u32 cut = 0u;
    if (all.allowed == ALLOWED_SOME) cut = middle_border(ON COLUMNS_OF_MASK, place.x, end);
    if (cut == 0u && all.is_mixed) cut = middle_border(ON COLUMNS_OF_FIELD, place.x, end);
    return cut == 0u && place.y > 1u ? place.x + place.y / 2u : cut;
}

BODY u32 cut_y(MEMORY const u32x4 place, const Under all) {
    u32 cut = 0u;
    if (all.allowed == ALLOWED_SOME) cut = middle_border(ON ROWS_OF_MASK, place.z, place.w);
    if (cut == 0u && all.is_mixed) cut = middle_border(ON ROWS_OF_FIELD, place.z, place.w);
    return cut;
}
