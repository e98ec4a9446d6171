// Turns radii into importance and stretches, pixel by pixel.
#include "pictures/ellipses.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string_view>

#include "files/npy.h"
#include "files/parse.h"
#include "files/read_whole.h"

namespace lacuna::pictures {
namespace {

constexpr double kMostRatio = 1000;

bool is_ellipse(const Radii& radii) {
    const auto& [first, second, angle] = radii;
    return first > 0 && second > 0 && std::isfinite(first * second) && first * second > 0 &&
           std::max(first, second) <= kMostRatio * std::min(first, second) && std::isfinite(angle);
}

// A stretch keeps the area: importance is 1 over the product of both radii.
void append(Field& field, const Radii& radii) {
    const auto& [first, second, angle] = radii;
    field.importance.push_back(1 / (first * second));
    const double turned = first >= second ? angle : angle + std::numbers::pi / 2;
    field.stretches.push_back({std::max(first, second) / std::min(first, second),
                               std::remainder(turned, std::numbers::pi)});
}

template <class Number>
void append_all(std::string_view data, const std::string& name, Field& field) {
    const std::size_t pixels = std::size_t{field.columns} * field.rows;
    if (data.size() != pixels * 3 * sizeof(Number))
        files::refuse(name, fmt::format("{} bytes of data: {} are announced", data.size(),
                                        pixels * 3 * sizeof(Number)));
    const auto number = [&](std::size_t i) {
        return double{files::load_little_endian<Number>(data.substr(i * sizeof(Number)))};
    };
    for (std::size_t i = 0; i < pixels; ++i) {
        const Radii radii{number(3 * i), number(3 * i + 1), number(3 * i + 2)};
        if (radii.first == 0 && radii.second == 0) {
            field.importance.push_back(0);
            field.stretches.push_back({});
            continue;
        }
        if (!is_ellipse(radii))
            files::refuse(
                fmt::format("{}: row {}, column {}", name, i / field.columns, i % field.columns),
                fmt::format("radii {} and {} at an angle of {}: must be finite, both "
                            "radii over 0 or both 0, one at most {} times the other",
                            radii.first, radii.second, radii.angle, kMostRatio));
        append(field, radii);
    }
}

}  // namespace

void add_pixel(Field& field, const Radii& radii, const char* option, const std::string& value) {
    if (!is_ellipse(radii))
        throw BadRequest(option, value,
                         fmt::format("radii and angle must be finite, radii over 0, one at most {} "
                                     "times the other",
                                     kMostRatio));
    append(field, radii);
}

Field read_ellipses(const std::string& path) {
    const std::string bytes = files::read_whole(path);
    const std::string name = files::name_of(path);
    std::string_view data = bytes;
    const files::NpyHeader header = files::take_npy_header(data, name);
    const bool is_double = header.descr == "<f8";
    if (header.shape.size() != 3 || header.shape[2] != 3 || header.fortran_order ||
        (!is_double && header.descr != "<f4"))
        files::refuse(name, fmt::format("an array of shape {} and type {}{}: must be rows x "
                                        "columns x 3 of <f8 or <f4, row by row",
                                        files::shape_text(header.shape), header.descr,
                                        header.fortran_order ? ", column by column" : ""));
    constexpr std::uint64_t kMostASide = 1U << 24U;
    if (std::min(header.shape[0], header.shape[1]) == 0 ||
        std::max(header.shape[0], header.shape[1]) > kMostASide)
        files::refuse(name, fmt::format("an array of shape {}: rows and columns must lie between 1 "
                                        "and {}",
                                        files::shape_text(header.shape), kMostASide));
    Field field;
    field.rows = static_cast<std::uint32_t>(header.shape[0]);
    field.columns = static_cast<std::uint32_t>(header.shape[1]);
    if (is_double)
        append_all<double>(data, name, field);
    else
        append_all<float>(data, name, field);
    if (std::all_of(field.importance.begin(), field.importance.end(),
                    [](double importance) { return importance == 0; }))
        files::refuse(name, "radii of 0 everywhere: some must be greater");
    return field;
}

}  // namespace lacuna::pictures
