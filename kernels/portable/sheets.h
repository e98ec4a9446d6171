// Classes of samples. Each class has a sheet: a copy of the domain that holds the places where its
// samples may still lie. Sheets lie side by side along x, 2^sheet_bits units apart, so x tells the
// class of a sample, a candidate or a box.
#ifndef LACUNA_PORTABLE_SHEETS_H
#define LACUNA_PORTABLE_SHEETS_H
#include "types.h"

// The most classes there can be, and the bits of x below which there is one sheet alone.
#define MOST_CLASSES 16u
#define BITS_OF_ONE_SHEET 31u

// Two classes keep a multiple of the least distance: a factor of 2^-32.
#define FACTOR_BITS 32u
#define FACTOR_ONE 0x100000000ul
// With classes no distance on the domain is as large, and its square fits into 62 bits.
#define LARGEST_LIMIT 0x7fffffffu

LACUNA_BEGIN

LACUNA_FN u32 sheet_of(u32 x, u32 sheet_bits) {
    return x >> sheet_bits;
}

// The x that the position has on its own sheet, from 0 to the domain's width.
LACUNA_FN u32 x_on_sheet(u32 x, u32 sheet_bits) {
    return x & ((1u << sheet_bits) - 1u);
}

// The x of the same position on the sheet on which `other_x` lies.
LACUNA_FN u32 x_beside(u32 x, u32 other_x, u32 sheet_bits) {
    return x_on_sheet(x, sheet_bits) | (other_x >> sheet_bits << sheet_bits);
}

// The product, rounded up. The factor's whole part and its fraction are multiplied one by one, so
// that each product fits into 64 bits.
LACUNA_FN u32 times_factor(u32 radius, u64 factor) {
    if (factor == FACTOR_ONE) return radius;
    u64 wide = radius;
    u64 product = wide * (factor >> FACTOR_BITS) +
                  ((wide * (factor & (FACTOR_ONE - 1u)) + (FACTOR_ONE - 1u)) >> FACTOR_BITS);
    return product < LARGEST_LIMIT ? to_u32(product) : LARGEST_LIMIT;
}

LACUNA_END

#endif
