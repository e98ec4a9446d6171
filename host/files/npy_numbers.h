// The numbers of .npy files, by the names that NumPy gives to their types.
#pragma once

#include <fmt/core.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "files/parse.h"

namespace lacuna::files {

// NumPy's bool: one byte, 0 or 1.
struct Bool {
    std::uint8_t byte;
};

// IEEE 754's binary16: a sign, 5 bits of exponent and 10 bits of fraction.
struct Half {
    std::uint16_t bits;
};

inline double value_of(Bool value) {
    return value.byte == 0 ? 0 : 1;
}

inline double value_of(Half half) {
    const auto exponent = static_cast<int>(half.bits >> 10U & 0x1fU);
    const double fraction = half.bits & 0x3ffU;
    constexpr int kSpecial = 0x1f, kBias = 15, kFractionBits = 10;
    double value = 0;
    if (exponent == kSpecial)
        value = fraction == 0 ? std::numeric_limits<double>::infinity()
                              : std::numeric_limits<double>::quiet_NaN();
    else if (exponent == 0)
        value = std::ldexp(fraction, 1 - kBias - kFractionBits);
    else
        value = std::ldexp(fraction + 1024, exponent - kBias - kFractionBits);
    return (half.bits & 0x8000U) != 0 ? -value : value;
}

// Whole numbers over 2^53 lose their last digits.
template <class Number>
double value_of(Number value) {
    return static_cast<double>(value);
}

// Calls `use` with a number of the type that `descr` names, such as <f8, and its byte order.
// Throws FileError for another type; `name` stands for the file.
template <class Use>
auto with_npy_numbers(std::string_view descr, const std::string& name, const Use& use) {
    const std::endian order = descr.starts_with('>') ? std::endian::big : std::endian::little;
    if (descr == "|u1") return use(std::uint8_t{}, order);
    if (descr == "|i1") return use(std::int8_t{}, order);
    if (descr == "|b1") return use(Bool{}, order);
    const std::string_view type = descr.substr(descr.empty() ? 0 : 1);
    if (descr.starts_with('<') || descr.starts_with('>')) {
        if (type == "u2") return use(std::uint16_t{}, order);
        if (type == "u4") return use(std::uint32_t{}, order);
        if (type == "u8") return use(std::uint64_t{}, order);
        if (type == "i2") return use(std::int16_t{}, order);
        if (type == "i4") return use(std::int32_t{}, order);
        if (type == "i8") return use(std::int64_t{}, order);
        if (type == "f2") return use(Half{}, order);
        if (type == "f4") return use(float{}, order);
        if (type == "f8") return use(double{}, order);
    }
    refuse(name, fmt::format("numbers of type {}: must be b1, i1 to i8, u1 to u8 or f2 to f8 "
                             "(bool, int8 to uint64, float16 to float64)",
                             excerpt(descr)));
}

}  // namespace lacuna::files
