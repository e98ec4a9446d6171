// The tables from which kernels read a radius field. backends/device/field_boxes.cpp makes them.
#ifndef LACUNA_PORTABLE_RADIUS_FIELD_H
#define LACUNA_PORTABLE_RADIUS_FIELD_H
#include "types.h"

// The table `axes` has the axes of the field's pixels and of the mask's pixels. Without a mask its
// axes have 0 pixels.
#define COLUMNS_OF_FIELD 0u
#define ROWS_OF_FIELD 1u
#define COLUMNS_OF_MASK 2u
#define ROWS_OF_MASK 3u

// The words of an axis.
#define AXIS_PIXELS 0u
#define AXIS_SHIFT 1u
#define AXIS_SCALE 2u   // two words, the lower one first
#define AXIS_LENGTH 4u  // in units
#define AXIS_LAST 5u    // a mask of the bits that x has on its copy (class_copies.h)
#define AXIS_ROOT 6u    // the slots of the root of a mask's tree are 2^root pixels wide
#define AXIS_WORDS 7u

// Whether none, some or all of an area is allowed, in two bits.
#define ALLOWED_NONE 0u
#define ALLOWED_SOME 1u
#define ALLOWED_ALL 2u

// The greatest radius of pixels shares a word with this bit. It is set if some of these pixels have
// no radius, because no sample may lie there.
#define HAS_ZEROS 0x80000000u

// The least radius under a box shares a word with this bit. It is set if samples may lie everywhere
// in the box, and all with this radius.
#define IS_EVEN 0x80000000u

LACUNA_BEGIN

// `at` is at most 2^30, the scale at most 2^34.
LACUNA_FN u32 pixel_at(u32 at, u32 scale_low, u32 scale_high, u32 shift) {
    u64 scale = scale_high;
    scale = (scale << 32) + scale_low;
    u64 wide = at;
    return to_u32(wide * scale >> shift);
}

// The first unit of a pixel; the length if there is no such pixel. If there are more pixels than
// units, some pixels have no unit.
LACUNA_FN u32 begin_of_pixel(u32 pixel, u32 pixels, u32 length, u32 scale_low, u32 scale_high,
                             u32 shift) {
    u64 wide = pixel;
    u64 units = length;
    u32 at = to_u32(wide * units / pixels);
    while (at < length && pixel_at(at, scale_low, scale_high, shift) < pixel) ++at;
    while (at > 0u && pixel_at(at - 1u, scale_low, scale_high, shift) >= pixel) --at;
    return at;
}

// 0 means "no radius". Subtracting 1 wraps it to the largest value: it never wins the minimum.
LACUNA_FN u32 least_of_radii(u32 a, u32 b) {
    u32 less_a = a - 1u;
    u32 less_b = b - 1u;
    return (less_a < less_b ? less_a : less_b) + 1u;
}

LACUNA_FN u32 greatest_of_radii(u32 a, u32 b) {
    u32 radius_a = a & ~HAS_ZEROS;
    u32 radius_b = b & ~HAS_ZEROS;
    return (radius_a > radius_b ? radius_a : radius_b) | ((a | b) & HAS_ZEROS);
}

LACUNA_FN bool are_radii_mixed(u32 least, u32 greatest) {
    return least != (greatest & ~HAS_ZEROS) || ((greatest & HAS_ZEROS) != 0u && least != 0u);
}

LACUNA_END

#endif
