// Cuts a rectangle into tiles that are nearly square.
#include "verify/tiles.h"

#include <algorithm>
#include <cmath>

namespace lacuna::verify {

std::vector<Cell> tiles_within(const Cell& bounds, const Tiling& tiling) {
    if (bounds.right < bounds.left || bounds.top < bounds.bottom) return {};
    const double width = bounds.right - bounds.left;
    const double height = bounds.top - bounds.bottom;
    if (width == 0 && height == 0) return {bounds};
    const auto tiles_along = [&](double side) {
        const double share = side / std::max(width, height);
        return std::max(1, static_cast<int>(std::ceil(tiling.along_longer_side * share)));
    };
    const int columns = tiles_along(width);
    const int rows = tiles_along(height);
    const auto cut = [&](double low, double high, int i, int count) {
        return i == count && tiling.ends_exactly ? high : low + (high - low) * i / count;
    };
    std::vector<Cell> tiles;
    for (int i = 0; i < columns; ++i)
        for (int j = 0; j < rows; ++j)
            tiles.push_back({cut(bounds.left, bounds.right, i, columns),
                             cut(bounds.left, bounds.right, i + 1, columns),
                             cut(bounds.bottom, bounds.top, j, rows),
                             cut(bounds.bottom, bounds.top, j + 1, rows)});
    return tiles;
}

Cell hull_of(std::span<const Cell> tiles) {
    Cell hull = tiles.front();
    for (const Cell& tile : tiles)
        hull = {std::min(hull.left, tile.left), std::max(hull.right, tile.right),
                std::min(hull.bottom, tile.bottom), std::max(hull.top, tile.top)};
    return hull;
}

}  // namespace lacuna::verify
