// Limits of the coordinates of rings.
#pragma once

#include <lacuna/domain.h>

#include <cmath>
#include <string_view>

namespace lacuna::places {

// Far beyond any domain, and small enough that products of two coordinates are finite.
inline constexpr double kLargest = 1e100;
inline constexpr std::string_view kFair = "both must be finite numbers between -1e100 and 1e100";

inline bool is_fair(Point point) {
    return std::abs(point.x) <= kLargest && std::abs(point.y) <= kLargest;
}

}  // namespace lacuna::places
