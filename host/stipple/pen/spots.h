// The dots in whole numbers, so that a pen path is the same on every machine.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

namespace lacuna::pen {

// A dot in units. The longer side of the area with dots has 2^25 units or a few more.
struct Spot {
    std::int64_t x;
    std::int64_t y;
};

inline std::int64_t squared_distance(const Spot& a, const Spot& b) {
    const std::int64_t dx = a.x - b.x, dy = a.y - b.y;
    return dx * dx + dy * dy;
}

// The distance in 1/16 units, rounded down. A squared distance is at most 2^51, which a double
// holds exactly, and IEEE 754 rounds the square root correctly.
inline std::int64_t distance(const Spot& a, const Spot& b) {
    return static_cast<std::int64_t>(std::sqrt(static_cast<double>(squared_distance(a, b))) * 16);
}

}  // namespace lacuna::pen
