// Derives a number of dots from a picture's darkness and its number of pixels.
#include "drawing/dot_count.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "files/point_files.h"

namespace lacuna::drawing {
namespace {

std::uint64_t rounded(double count) {
    return static_cast<std::uint64_t>(std::clamp(std::round(count), 1.0, kMostDots));
}

}  // namespace

double darkness_of(const Field& field) {
    return std::accumulate(field.importance.begin(), field.importance.end(), 0.0) /
           static_cast<double>(field.importance.size());
}

std::uint64_t dot_count(const Field& field, double width, double height) {
    constexpr double kPixelsPerDot = 16;  // of black: a dot then covers 4 x 4 pixels
    constexpr double kLeastSide = 512, kMostSide = 2048;
    const double longer =
        std::clamp<double>(std::max(field.columns, field.rows), kLeastSide, kMostSide);
    return rounded(darkness_of(field) * width * longer * height * longer / kPixelsPerDot);
}

std::uint64_t default_count(const Field& field, double width, double height,
                            std::optional<double> dot_size_mm, const Style& style) {
    return dot_size_mm ? rounded(dots_for_ink(field, width, height, *dot_size_mm, style))
                       : dot_count(field, width, height);
}

double dots_for_ink(const Field& field, double width, double height, double dot_size_mm,
                    const Style& style) {
    const double scale = millimetres_per_unit(files::PointSet{{}, width, height}, style);
    const double dot = std::numbers::pi / 4 * dot_size_mm * dot_size_mm;
    return darkness_of(field) * width * scale * height * scale / dot;
}

}  // namespace lacuna::drawing
