// The pixels of a picture at a point in the user's units.
#pragma once

#include <lacuna/lacuna.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace lacuna {

// Calls `use` with the index of every pixel on which the point may be said to lie, as samples are
// rounded: those within 2^-28 of the longer side, a little over the rounding. The picture is
// stretched over the domain.
template <class Use>
void for_pixels_at(Point point, const Domain& domain, std::uint32_t columns, std::uint32_t rows,
                   const Use& use) {
    const double near = 0x1p-28 * domain.longer_side();
    const auto pixel_of = [](double share, std::uint32_t pixels) {
        const double last = pixels - 1.0;
        return static_cast<std::uint32_t>(std::clamp(std::floor(share * pixels), 0.0, last));
    };
    const Point at = domain.from_corner(point);
    const std::uint32_t left = pixel_of((at.x - near) / domain.width, columns);
    const std::uint32_t right = pixel_of((at.x + near) / domain.width, columns);
    const std::uint32_t low = pixel_of((at.y - near) / domain.height, rows);
    const std::uint32_t high = pixel_of((at.y + near) / domain.height, rows);
    for (std::uint32_t up = low; up <= high; ++up)
        for (std::uint32_t column = left; column <= right; ++column)
            use(std::size_t{rows - 1 - up} * columns + column);
}

}  // namespace lacuna
