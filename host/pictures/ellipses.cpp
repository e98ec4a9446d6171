// Turns ellipses into importance and stretches, pixel by pixel.
#include "pictures/ellipses.h"

#include <fmt/core.h>
#include <lacuna/pictures.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string_view>
#include <vector>

#include "base/polling.h"
#include "files/npy.h"
#include "files/parse.h"
#include "files/read_whole.h"

namespace lacuna::pictures {
namespace {

bool is_zero(const Ellipse& ellipse) {
    return ellipse.a == 0 && ellipse.b == 0;
}

bool are_zero(std::span<const Ellipse> ellipses) {
    return std::all_of(ellipses.begin(), ellipses.end(), is_zero);
}

// The place of the first ellipse that is neither allowed nor 0, and what it is.
struct Fault {
    std::string place;
    std::string text;
};
std::optional<Fault> fault_in(std::span<const Ellipse> ellipses, std::size_t columns) {
    const auto found = std::find_if(ellipses.begin(), ellipses.end(), [](const Ellipse& ellipse) {
        return !is_zero(ellipse) && !is_allowed(ellipse);
    });
    if (found == ellipses.end()) return std::nullopt;
    const auto pixel = static_cast<std::size_t>(found - ellipses.begin());
    return Fault{
        fmt::format("row {}, column {}", pixel / columns, pixel % columns),
        fmt::format("radii {} and {} at an angle of {}", found->a, found->b, found->angle)};
}

template <class Number>
std::vector<Ellipse> ellipses_in(std::string_view data, std::size_t pixels,
                                 const std::string& name) {
    if (data.size() != pixels * 3 * sizeof(Number))
        files::refuse(name, fmt::format("{} bytes of data: {} are announced", data.size(),
                                        pixels * 3 * sizeof(Number)));
    const auto number = [&](std::size_t i) {
        return double{files::load_little_endian<Number>(data.substr(i * sizeof(Number)))};
    };
    std::vector<Ellipse> ellipses;
    ellipses.reserve(pixels);
    for_each_polled(pixels, ask, [&](std::size_t i) {
        ellipses.push_back({number(3 * i), number(3 * i + 1), number(3 * i + 2)});
    });
    return ellipses;
}

}  // namespace

bool is_allowed(const Ellipse& ellipse) {
    constexpr double kMostRatio = 1000;
    const auto& [first, second, angle] = ellipse;
    ask_after();
    return first > 0 && second > 0 && std::isfinite(first * second) && first * second > 0 &&
           std::max(first, second) <= kMostRatio * std::min(first, second) && std::isfinite(angle);
}

// A stretch keeps the area: importance is 1 over the product of both radii.
Field field_of(std::uint32_t columns, std::uint32_t rows, std::span<const Ellipse> ellipses) {
    Field field{columns, rows, {}};
    for (const auto& [first, second, angle] : ellipses) {
        ask_after();
        const double turned = first >= second ? angle : angle + std::numbers::pi / 2;
        field.importance.push_back(first == 0 ? 0 : 1 / (first * second));
        field.stretches.push_back(first == 0
                                      ? Stretch{}
                                      : Stretch{std::max(first, second) / std::min(first, second),
                                                std::remainder(turned, std::numbers::pi)});
    }
    return field;
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
    const std::size_t pixels = header.shape[0] * header.shape[1];
    const std::vector<Ellipse> ellipses = is_double ? ellipses_in<double>(data, pixels, name)
                                                    : ellipses_in<float>(data, pixels, name);
    if (const auto fault = fault_in(ellipses, header.shape[1]))
        files::refuse(fmt::format("{}: {}", name, fault->place),
                      fmt::format("{}: {}, or both radii 0", fault->text, kAllowedEllipse));
    if (are_zero(ellipses)) files::refuse(name, "radii of 0 everywhere: some must be greater");
    return field_of(static_cast<std::uint32_t>(header.shape[1]),
                    static_cast<std::uint32_t>(header.shape[0]), ellipses);
}

}  // namespace lacuna::pictures

namespace lacuna {

Field ellipse_field(std::uint32_t columns, std::uint32_t rows, std::span<const Ellipse> ellipses) {
    if (columns == 0 || ellipses.size() != std::size_t{columns} * rows)
        throw BadRequest("ellipses", fmt::format("{}", ellipses.size()),
                         fmt::format("there must be one for each of {} x {} pixels, at least one",
                                     rows, columns));
    if (const auto fault = pictures::fault_in(ellipses, columns))
        throw BadRequest("ellipses", fmt::format("{}: {}", fault->place, fault->text),
                         fmt::format("{}, or both radii 0", pictures::kAllowedEllipse));
    if (pictures::are_zero(ellipses))
        throw BadRequest("ellipses", "with radii of 0 everywhere", "some must be greater");
    return pictures::field_of(columns, rows, ellipses);
}

}  // namespace lacuna
