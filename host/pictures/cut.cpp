// Turns pictures, and cuts them to a part.
#include <fmt/core.h>

#include <cstddef>
#include <utility>
#include <vector>

#include "base/polling.h"
#include "pictures/importance.h"

namespace lacuna::pictures {

void cut(Image& image, const Importance& options) {
    constexpr std::uint32_t kQuarter = 90;
    if (options.turn == 0 && options.crop == Part{}) return;
    const std::size_t across = image.columns, down = image.rows;
    Part part = options.crop;
    std::uint32_t columns = image.columns, rows = image.rows;
    if (options.turn % (2 * kQuarter) != 0) std::swap(columns, rows);
    if (part == Part{}) part = {0, 0, columns, rows};
    const auto reaches_over = [](std::uint32_t first, std::uint32_t count, std::uint32_t all) {
        return count == 0 || first >= all || count > all - first;
    };
    if (reaches_over(part.left, part.columns, columns) || reaches_over(part.top, part.rows, rows))
        throw BadRequest(
            "crop", fmt::format("{},{},{},{}", part.left, part.top, part.columns, part.rows),
            fmt::format("must lie within the {} x {} pixels of {}", columns, rows, image.name));
    // Where a pixel of the turned picture comes from.
    const auto index_of = [&](std::size_t x, std::size_t y) {
        if (options.turn == kQuarter) return (down - 1 - x) * across + y;
        if (options.turn == 2 * kQuarter) return (down - 1 - y) * across + across - 1 - x;
        if (options.turn == 3 * kQuarter) return x * across + across - 1 - y;
        return y * across + x;
    };
    std::vector<double> luminance;
    luminance.reserve(std::size_t{part.columns} * part.rows);
    for (std::size_t y = part.top; y < part.top + part.rows; ++y) {
        ask_after(part.columns);
        for (std::size_t x = part.left; x < part.left + part.columns; ++x)
            luminance.push_back(image.luminance[index_of(x, y)]);
    }
    image.columns = part.columns;
    image.rows = part.rows;
    image.luminance = std::move(luminance);
}

}  // namespace lacuna::pictures
