// Sharpens a picture by an unsharp mask.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "pictures/importance.h"

namespace lacuna::pictures {
namespace {

// Replaces each value of a row, or of a column with `step` between its values, by the mean of those
// up to `radius` away. Beyond an edge the value at the edge counts.
void blur(std::span<double> values, std::size_t step, std::size_t count, std::size_t radius,
          std::vector<double>& before) {
    before.resize(count);
    for (std::size_t i = 0; i < count; ++i) before[i] = values[i * step];
    const auto at = [&](std::ptrdiff_t i) {
        return before[static_cast<std::size_t>(
            std::clamp<std::ptrdiff_t>(i, 0, static_cast<std::ptrdiff_t>(count) - 1))];
    };
    const auto reach = static_cast<std::ptrdiff_t>(radius);
    double sum = 0;
    for (std::ptrdiff_t i = -reach; i <= reach; ++i) sum += at(i);
    for (std::size_t i = 0; i < count; ++i) {
        values[i * step] = sum / static_cast<double>(2 * radius + 1);
        const auto here = static_cast<std::ptrdiff_t>(i);
        sum += at(here + reach + 1) - at(here - reach);
    }
}

}  // namespace

// Three means one after the other are nearly a Gaussian blur, and the same on every machine.
void sharpen(Image& image, const Importance& options) {
    const std::size_t radius = options.sharpen;
    if (radius == 0) return;
    std::vector<double> blurred = image.luminance;
    const std::span<double> all = blurred;
    std::vector<double> line;
    for (int mean = 0; mean < 3; ++mean) {
        for (std::size_t y = 0; y < image.rows; ++y)
            blur(all.subspan(y * image.columns), 1, image.columns, radius, line);
        for (std::size_t x = 0; x < image.columns; ++x)
            blur(all.subspan(x), image.columns, image.rows, radius, line);
    }
    // A smaller difference is of rounding: it must not put importance on white.
    const double least = 1e-9 * image.white;
    for (std::size_t i = 0; i < blurred.size(); ++i) {
        const double edge = image.luminance[i] - blurred[i];
        if (std::abs(edge) < least) continue;
        image.luminance[i] =
            std::clamp(image.luminance[i] + options.sharpen_amount * edge, 0.0, image.white);
    }
}

}  // namespace lacuna::pictures
