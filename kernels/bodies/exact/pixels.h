// The pixels of a field or a mask, from the table `axes`.
#ifndef LACUNA_BODIES_PIXELS_H
#define LACUNA_BODIES_PIXELS_H
#include "portable/radius_field.h"

// An axis of a grid of pixels, see portable/radius_field.h.
struct Axis {
    u32 pixels;
    u32 shift;
    u32 scale_low;
    u32 scale_high;
    u32 units;  // its length
    u32 last;   // in x, the last unit of a copy (portable/class_copies.h); in y all bits are set
    u32 root;   // of the mask's tree
};
LACUNA_TYPEDEF(Axis)

struct PixelGrid {
    Axis columns;
    Axis rows;
};
LACUNA_TYPEDEF(PixelGrid)

BODY Axis axis_of(MEMORY const u32 number) {
    const u32 first = number * AXIS_WORDS;
    const Axis axis = {AT(axes, first + AXIS_PIXELS), AT(axes, first + AXIS_SHIFT),
                       AT(axes, first + AXIS_SCALE),  AT(axes, first + AXIS_SCALE + 1u),
                       AT(axes, first + AXIS_LENGTH), AT(axes, first + AXIS_LAST),
                       AT(axes, first + AXIS_ROOT)};
    return axis;
}

// `columns` is the number of the axis of columns; the axis of rows follows it.
BODY PixelGrid grid_of(MEMORY const u32 columns) {
    const PixelGrid grid = {axis_of(ON columns), axis_of(ON columns + 1u)};
    return grid;
}

BODY u32 pixel_of(const Axis axis, const u32 at) {
    return pixel_at(at & axis.last, axis.scale_low, axis.scale_high, axis.shift);
}

BODY u32 begin_of(const Axis axis, const u32 pixel) {
    return begin_of_pixel(pixel, axis.pixels, axis.units, axis.scale_low, axis.scale_high,
                          axis.shift);
}

#endif
