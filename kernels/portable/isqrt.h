// The exact integer square root: any estimate, corrected by comparing whole numbers.
#ifndef LACUNA_PORTABLE_ISQRT_H
#define LACUNA_PORTABLE_ISQRT_H
#include "types.h"

LACUNA_BEGIN

// The largest whole number whose square is at most n, for n < 2^63.
LACUNA_FN u64 isqrt(u64 n) {
    u64 root = sqrt_estimate(n);
    while (root * root > n) root = root - 1u;
    while ((root + 1u) * (root + 1u) <= n) root = root + 1u;
    return root;
}

LACUNA_END

#endif
