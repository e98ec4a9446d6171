// What the columns of a file hold, found by their names, and the set that its rows make.
#pragma once

#include <lacuna/lacuna.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "files/read_points.h"

namespace lacuna::files {

// Returns the place of `word` among the names, which gets it if it is new. Throws FileError for
// the 256th name, and for an empty one; `place` stands for its place in the file.
std::uint8_t place_among(std::vector<std::string>& names, std::string_view word,
                         const std::string& place);

// Whether the name is `word`, in upper or lower case.
bool is_called(std::string_view name, std::string_view word);

// The columns of a file, as places among all columns: the coordinates, the class or ink of each
// point, and its ellipse. Ellipses have all three of a, b and angle, or there are none.
struct PointColumns {
    std::size_t x = 0;
    std::size_t y = 1;
    std::optional<std::size_t> z, of_class, ink, a, b, angle;
    std::optional<std::size_t> radius;  // of objects with classes, not of dots on a page
    std::vector<std::string> others;    // names of the other columns, which are not read

    // Two columns, x and y.
    PointColumns() = default;
    // Finds the columns by their names, in upper or lower case: x and y or, without these, easting
    // and northing, or lon or longitude, and lat or latitude. Throws FileError, in which `place`
    // stands for the header, if there is no such pair, or if there are two without x and y.
    PointColumns(std::span<const std::string> names, const std::string& place);
};

}  // namespace lacuna::files
