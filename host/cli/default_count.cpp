// The number of dots that suits a picture.
#include "cli/default_count.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "drawing/dot_count.h"

namespace lacuna::cli {

std::uint64_t default_count(const Field& field, const Request& request,
                            const DrawingOptions& options, const drawing::Style& style) {
    if (!options.dot_size_mm) return drawing::dot_count(field, request.width, request.height);
    const double scale =
        drawing::millimetres_per_unit(files::PointSet{{}, request.width, request.height}, style);
    const double dot = std::numbers::pi / 4 * *options.dot_size_mm * *options.dot_size_mm;
    const double count =
        drawing::darkness_of(field) * request.width * scale * request.height * scale / dot;
    return static_cast<std::uint64_t>(std::clamp(std::round(count), 1.0, drawing::kMostDots));
}

}  // namespace lacuna::cli
