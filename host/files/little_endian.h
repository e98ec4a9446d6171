// The bytes of a float64 in files and digests: the lowest byte first, on any machine.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

namespace lacuna::files {

static_assert(std::numeric_limits<double>::is_iec559 && sizeof(double) == 8);

inline void append_little_endian(std::string& bytes, double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    std::array<char, 8> number{};
    for (std::size_t i = 0; i < number.size(); ++i)
        number[i] = static_cast<char>((bits >> (8 * i)) & 0xffU);
    bytes.append(number.data(), number.size());
}

}  // namespace lacuna::files
