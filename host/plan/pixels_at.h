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
// stretched over the domain; on a torus its first pixels lie beside the last ones.
template <class Use>
void for_pixels_at(Point point, const Domain& domain, std::uint32_t columns, std::uint32_t rows,
                   const Use& use) {
    const double near = 0x1p-28 * domain.longer_side();
    const auto pixel_of = [&](double share, std::uint32_t pixels) {
        const double pixel = std::floor(share * pixels);
        return static_cast<std::int64_t>(domain.wraps() ? pixel
                                                        : std::clamp(pixel, 0.0, pixels - 1.0));
    };
    const auto wrapped = [](std::int64_t pixel, std::int64_t pixels) {
        return static_cast<std::size_t>((pixel % pixels + pixels) % pixels);
    };
    const Point at = domain.from_corner(point);
    const std::int64_t left = pixel_of((at.x - near) / domain.width, columns);
    const std::int64_t right = pixel_of((at.x + near) / domain.width, columns);
    const std::int64_t low = pixel_of((at.y - near) / domain.height, rows);
    const std::int64_t high = pixel_of((at.y + near) / domain.height, rows);
    for (std::int64_t up = low; up <= high; ++up)
        for (std::int64_t column = left; column <= right; ++column)
            use((rows - 1 - wrapped(up, rows)) * columns + wrapped(column, columns));
}

}  // namespace lacuna
