// The number of dots that suits a picture.
#include "cli/default_count.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>

namespace lacuna::cli {

std::uint64_t default_count(const Field& field, const Request& request,
                            const DrawingOptions& options, const drawing::Style& style) {
    constexpr double kMost = 1e6;
    const double darkness = std::accumulate(field.importance.begin(), field.importance.end(), 0.0) /
                            static_cast<double>(field.importance.size());
    double count = 0;
    if (options.dot_size_mm) {
        const double scale = drawing::millimetres_per_unit(
            files::PointSet{{}, request.width, request.height}, style);
        const double dot = std::numbers::pi / 4 * *options.dot_size_mm * *options.dot_size_mm;
        count = darkness * request.width * scale * request.height * scale / dot;
    } else {
        constexpr double kPixelsPerDot = 16;  // of black: a dot then covers 4 x 4 pixels
        constexpr double kLeastSide = 512, kMostSide = 2048;
        const double longer =
            std::clamp<double>(std::max(field.columns, field.rows), kLeastSide, kMostSide);
        // The request's longer side is 1.
        count = darkness * request.width * longer * request.height * longer / kPixelsPerDot;
    }
    return static_cast<std::uint64_t>(std::clamp(std::round(count), 1.0, kMost));
}

}  // namespace lacuna::cli
