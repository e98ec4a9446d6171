// Finds columns by their names.
#include "files/point_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "files/parse.h"

namespace lacuna::files {

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
    constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kPairs{
        {{"x", "y"},
         {"easting", "northing"},
         {"lon", "lat"},
         {"lon", "latitude"},
         {"longitude", "lat"},
         {"longitude", "latitude"}}};
    std::vector<std::pair<std::size_t, std::size_t>> found;
    for (const auto& [across, up] : kPairs)
        if (const auto named_x = find(across), named_y = find(up); named_x && named_y)
            if (found.emplace_back(*named_x, *named_y); across == "x") break;
    if (found.size() != 1)
        refuse(place, fmt::format("the columns are {}: two must be called x and y{}",
                                  excerpt(fmt::format("{}", fmt::join(names, ","))),
                                  found.empty() ? ", lon and lat, or easting and northing"
                                                : ", if there is more than one pair"));
    std::tie(x, y) = found.front();
    z = find("z");
    of_class = find("class");
    ink = find("ink");
    a = find("a");
    b = find("b");
    angle = find("angle");
    if (of_class && !find("x_mm")) radius = find("radius");
    if (!a || !b || !angle) a = b = angle = std::nullopt;
    for (std::size_t i = 0; i < names.size(); ++i)
        if (i != x && i != y && i != z && i != of_class && i != ink && i != a && i != b &&
            i != angle && i != radius)
            others.push_back(names[i]);
}

}  // namespace lacuna::files
