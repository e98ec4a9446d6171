// A radius field as kernels hold it: the words of its tables, which plan/radius_field.h fills.
#ifndef LACUNA_PORTABLE_RADIUS_FIELD_H
#define LACUNA_PORTABLE_RADIUS_FIELD_H
#include "prelude.h"

// The table `axes` begins with the axes of a field's pixels and, where there is a mask, of its
// pixels; without one they have none. Then come the begins of their pixels.
#define COLUMNS_OF_FIELD 0u
#define ROWS_OF_FIELD 1u
#define COLUMNS_OF_MASK 2u
#define ROWS_OF_MASK 3u

// The words of an axis.
#define AXIS_PIXELS 0u
#define AXIS_SHIFT 1u
#define AXIS_SCALE 2u   // two words, the lower one first
#define AXIS_BEGINS 4u  // where the begins of its pixels are in the table
#define AXIS_WORDS 5u

// What of pixels is allowed, in two bits.
#define ALLOWED_NONE 0u
#define ALLOWED_SOME 1u
#define ALLOWED_ALL 2u
#define ALLOWED_PER_WORD 16u

// The greatest radius of pixels shares a word with this bit, which tells that some of them have
// none.
#define HAS_ZEROS 0x80000000u

// The words of list_counts[]: how long new_uneven[] and several[] are.
#define OF_NEW_UNEVEN 0u
#define OF_SEVERAL 1u

// The least radius under a place shares a word with this bit, which tells that all of the place is
// allowed and has that radius.
#define IS_EVEN 0x80000000u

LACUNA_BEGIN

// Values are at most 2^30, the scale at most 2^34.
LACUNA_FN u32 pixel_at(u32 at, u32 scale_low, u32 scale_high, u32 shift) {
    u64 scale = scale_high;
    scale = (scale << 32) + scale_low;
    u64 wide = at;
    return to_u32(wide * scale >> shift);
}

// Of two values of a pyramid. One less than no radius is the most.
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
