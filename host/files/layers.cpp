// The layers of a set, one for each ink or class.
#include <fmt/core.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "files/point_files.h"

namespace lacuna::files {

std::string hex_of(const Colour& colour) {
    return fmt::format("#{:02x}{:02x}{:02x}", colour[0], colour[1], colour[2]);
}

std::vector<std::uint8_t> layers_of_points(const PointSet& set) {
    std::vector<std::uint8_t> layers(set.layer_of_point.begin(), set.layer_of_point.end());
    for (std::size_t k = 0; set.layer_of_point.empty() && k < set.layers.size(); ++k)
        layers.insert(layers.end(), set.layers[k].dots, static_cast<std::uint8_t>(k));
    return layers;
}

std::vector<Layer> layers_of_classes(std::span<const std::string> names,
                                     std::span<const std::uint8_t> class_of_point) {
    // The first eight can be told apart by colour-blind readers, too (Okabe & Ito 2008).
    constexpr std::array<std::array<std::uint8_t, 3>, 16> kColours{{{0x00, 0x9e, 0x73},
                                                                    {0xe6, 0x9f, 0x00},
                                                                    {0x00, 0x72, 0xb2},
                                                                    {0xd5, 0x5e, 0x00},
                                                                    {0xcc, 0x79, 0xa7},
                                                                    {0x56, 0xb4, 0xe9},
                                                                    {0x00, 0x00, 0x00},
                                                                    {0xd8, 0xc9, 0x00},
                                                                    {0x6a, 0x3d, 0x9a},
                                                                    {0x8c, 0x56, 0x4b},
                                                                    {0x7f, 0x7f, 0x7f},
                                                                    {0xb2, 0xdf, 0x8a},
                                                                    {0xfb, 0x9a, 0x99},
                                                                    {0x1b, 0x5e, 0x20},
                                                                    {0x80, 0x00, 0x20},
                                                                    {0x17, 0x3f, 0x8a}}};
    std::vector<Layer> layers;
    std::size_t kinds = 0;  // sizes of one kind have its name and its colour
    for (const std::string& name : names) {
        if (layers.empty() || layers.back().ink.name != name) ++kinds;
        layers.push_back({{name, kColours[(kinds - 1) % kColours.size()]}, 0});
    }
    for (const std::uint8_t one : class_of_point) ++layers[one].dots;
    return layers;
}

}  // namespace lacuna::files
