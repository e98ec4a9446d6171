// Classes of samples. Each class has a copy of the domain, which holds the places where its
// samples may still lie. Copies lie side by side along x, 2^copy_bits units apart, so x tells the
// class of a sample, a candidate or a box.
#ifndef LACUNA_PORTABLE_CLASS_COPIES_H
#define LACUNA_PORTABLE_CLASS_COPIES_H
#include "types.h"

// The most classes there can be, and the bits of x below which there is one copy alone.
#define MOST_CLASSES 16u
#define BITS_OF_ONE_COPY 31u

// Two classes keep a multiple of the least distance: a factor of 2^-32.
#define FACTOR_BITS 32u
#define FACTOR_ONE 0x100000000ul
// With classes no distance on the domain is as large, and its square fits into 62 bits.
#define LARGEST_LIMIT 0x7fffffffu

LACUNA_BEGIN

LACUNA_FN u32 copy_of(u32 x, u32 copy_bits) {
    return x >> copy_bits;
}

// The x that the position has on its own copy, from 0 to the domain's width.
LACUNA_FN u32 x_on_copy(u32 x, u32 copy_bits) {
    return x & ((1u << copy_bits) - 1u);
}

// The x of the same position on the copy on which `other_x` lies.
LACUNA_FN u32 x_beside(u32 x, u32 other_x, u32 copy_bits) {
    return x_on_copy(x, copy_bits) | (other_x >> copy_bits << copy_bits);
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
