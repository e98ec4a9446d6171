// Parts of pictures that have an extent of their own, such as a map's.
#pragma once

#include <lacuna/places.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace lacuna::places {

// The pixels of a domain in a picture with this extent: the first one's column and row, from the
// top, and how many there are. They may lie beyond the picture.
struct Part {
    std::int64_t column = 0;
    std::int64_t row = 0;
    std::uint32_t columns = 0;
    std::uint32_t rows = 0;
};
// Throws BadRequest that names `option` if an edge of the domain lies on no border of pixels.
Part part_of(const Raster& picture, const Domain& extent, const Domain& domain, const char* option);

// The values of the part's pixels, row by row; 0 beyond the picture.
template <class Value>
std::vector<Value> cut(const std::vector<Value>& values, const Raster& picture, const Part& part) {
    std::vector<Value> own(std::size_t{part.columns} * part.rows);
    for (std::uint32_t row = 0; row < part.rows; ++row)
        for (std::uint32_t column = 0; column < part.columns; ++column) {
            const std::int64_t x = part.column + column, y = part.row + row;
            if (x < 0 || y < 0 || x >= picture.columns || y >= picture.rows) continue;
            own[std::size_t{row} * part.columns + column] =
                values[static_cast<std::size_t>(y) * picture.columns + static_cast<std::size_t>(x)];
        }
    return own;
}

bool has_extents(const Places& places);
// Cuts the masks that have an extent to the domain: the places then point into what is returned,
// which is null if there are none. Throws BadRequest.
std::shared_ptr<const std::vector<Mask>> cut_masks(const Domain& domain, Places& places);

}  // namespace lacuna::places
