// The layers of a set, one for each ink.
#include <fmt/core.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "files/point_files.h"

namespace lacuna::files {

std::string hex_of(const std::array<std::uint8_t, 3>& colour) {
    return fmt::format("#{:02x}{:02x}{:02x}", colour[0], colour[1], colour[2]);
}

std::vector<std::uint8_t> layers_of_points(const PointSet& set) {
    std::vector<std::uint8_t> layers;
    for (std::size_t k = 0; k < set.layers.size(); ++k)
        layers.insert(layers.end(), set.layers[k].dots, static_cast<std::uint8_t>(k));
    return layers;
}

}  // namespace lacuna::files
