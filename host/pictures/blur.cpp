// Blurs pictures by means along rows and columns.
#include "pictures/blur.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "base/polling.h"

namespace lacuna::pictures {
namespace {

// The mean along a row, or along a column with `step` between its values.
void blur_line(std::span<double> values, std::size_t step, std::size_t count, std::size_t radius,
               std::vector<double>& before) {
    ask_after(count);
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

void blur(std::span<double> values, std::size_t columns, std::size_t rows, std::size_t radius) {
    std::vector<double> line;
    for (int mean = 0; mean < 3; ++mean) {
        for (std::size_t y = 0; y < rows; ++y)
            blur_line(values.subspan(y * columns), 1, columns, radius, line);
        for (std::size_t x = 0; x < columns; ++x)
            blur_line(values.subspan(x), columns, rows, radius, line);
    }
}

}  // namespace lacuna::pictures
