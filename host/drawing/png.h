// Writes PNG files with libpng.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>

namespace lacuna::drawing {

struct Png {
    std::uint32_t columns = 1;
    std::uint32_t rows = 1;
    unsigned channels = 1;  // 1: grey; 3: red, green and blue
    unsigned bits = 8;      // of each number, 8 or 16
    std::optional<double> pixels_per_inch{};
};

// The bytes of the file. `fill` is called for each row, from the top on, and writes the row's
// numbers into `bytes`: pixel by pixel, of 16 bits the higher byte first.
using FillRow = std::function<void(std::size_t row, std::span<std::uint8_t> bytes)>;
std::string encode_png(const Png& png, const FillRow& fill);

}  // namespace lacuna::drawing
