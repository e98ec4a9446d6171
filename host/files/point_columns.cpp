// Finds columns by their names.
#include "files/point_columns.h"

#include <fmt/format.h>

#include <algorithm>

#include "files/parse.h"

namespace lacuna::files {

void ThirdCoordinate::add(double z, std::size_t index) {
    if (!first_) first_ = z;
    if (z != *first_)
        refuse(name_, fmt::format("point {} has z {}, and point 0 has {}: points of the plane must "
                                  "have the same z, or none",
                                  index, z, *first_));
}

std::uint8_t place_among(std::vector<std::string>& names, std::string_view word,
                         const std::string& place) {
    constexpr std::size_t kMostNames = 255;
    if (word.empty()) refuse(place, "there is no class or ink");
    const auto found = std::find(names.begin(), names.end(), word);
    const auto index = static_cast<std::size_t>(found - names.begin());
    if (found == names.end()) names.emplace_back(word);
    if (names.size() > kMostNames)
        refuse(place, fmt::format("must have at most {} classes or inks", kMostNames));
    return static_cast<std::uint8_t>(index);
}

bool is_called(std::string_view name, std::string_view word) {
    return std::equal(name.begin(), name.end(), word.begin(), word.end(),
                      [](char a, char b) { return lower_case(a) == b; });
}

PointColumns::PointColumns(std::span<const std::string> names, const std::string& place) {
    const auto find = [&](std::string_view word) -> std::optional<std::size_t> {
        const auto has_it = [&](const std::string& name) { return is_called(name, word); };
        const auto count = std::count_if(names.begin(), names.end(), has_it);
        if (count > 1) refuse(place, fmt::format("{} columns are called {}", count, word));
        if (count == 0) return std::nullopt;
        return std::find_if(names.begin(), names.end(), has_it) - names.begin();
    };
    const std::optional<std::size_t> named_x = find("x"), named_y = find("y");
    if (!named_x || !named_y)
        refuse(place, fmt::format("the columns are {}: one must be called x and one y",
                                  excerpt(fmt::format("{}", fmt::join(names, ",")))));
    x = *named_x;
    y = *named_y;
    z = find("z");
    of_class = find("class");
    ink = find("ink");
    a = find("a");
    b = find("b");
    angle = find("angle");
    if (!a || !b || !angle) a = b = angle = std::nullopt;
    for (std::size_t i = 0; i < names.size(); ++i)
        if (i != x && i != y && i != z && i != of_class && i != ink && i != a && i != b &&
            i != angle)
            others.push_back(names[i]);
}

}  // namespace lacuna::files
