// Powers of numbers from 0 to 1, the same to the last bit on every machine, unlike std::pow.
#pragma once

#include <cmath>
#include <cstdint>

namespace lacuna {

// base^exponent for a base from 0 to 1 and a finite exponent of at least 0. IEEE 754 defines
// products and square roots to the last bit, and nothing else is used: the whole part of the
// exponent by repeated squares, and its first 24 binary digits behind the point by repeated roots.
inline double power(double base, double exponent) {
    constexpr double kMostWhole = 1U << 20U;  // any base under 1 - 2^-10 is then 0 in doubles
    constexpr int kDigits = 24;
    if (base == 1 || base == 0) return exponent == 0 ? 1 : base;
    if (exponent >= kMostWhole) exponent = kMostWhole;
    const double whole = std::floor(exponent);
    double result = 1;
    double square = base;
    for (auto rest = static_cast<std::uint32_t>(whole); rest != 0; rest /= 2) {
        if (rest % 2 != 0) result *= square;
        square *= square;
    }
    double fraction = exponent - whole;
    double root = base;
    for (int digit = 0; digit < kDigits && fraction != 0; ++digit) {
        root = std::sqrt(root);
        fraction *= 2;
        if (fraction < 1) continue;
        result *= root;
        fraction -= 1;
    }
    return result;
}

}  // namespace lacuna
