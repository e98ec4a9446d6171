// Counts the dots of a picture by its darkness and its pixels.
#include "drawing/dot_count.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lacuna::drawing {

double darkness_of(const Field& field) {
    return std::accumulate(field.importance.begin(), field.importance.end(), 0.0) /
           static_cast<double>(field.importance.size());
}

std::uint64_t dot_count(const Field& field, double width, double height) {
    constexpr double kPixelsPerDot = 16;  // of black: a dot then covers 4 x 4 pixels
    constexpr double kLeastSide = 512, kMostSide = 2048;
    const double longer =
        std::clamp<double>(std::max(field.columns, field.rows), kLeastSide, kMostSide);
    const double count = darkness_of(field) * width * longer * height * longer / kPixelsPerDot;
    return static_cast<std::uint64_t>(std::clamp(std::round(count), 1.0, kMostDots));
}

}  // namespace lacuna::drawing
