// Writes grey PNG files.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace lacuna::pictures {

// The bytes of a grey PNG of 8 or 16 bits. `values` are row by row, row 0 on top, each under
// 2^bits.
std::string grey_png(std::uint32_t columns, unsigned bits, std::span<const std::uint16_t> values);

}  // namespace lacuna::pictures
