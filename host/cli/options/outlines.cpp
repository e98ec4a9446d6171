// Reads outlines: polygons and obstacles.
#include "cli/options/domain_options.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/number_text.h"
#include "domains/rings.h"
#include "files/csv_rows.h"
#include "files/parse.h"
#include "files/point_columns.h"
#include "files/read_whole.h"

namespace lacuna::cli {
namespace {

struct FileAndWidth {
    std::string path;
    std::optional<double> width;
    bool is_of_strokes = false;
};

// A colon begins the width if a number follows, to the end, or the word `stroke`.
FileAndWidth file_and_width(const std::string& text) {
    const std::size_t colon = text.rfind(':');
    if (colon == std::string::npos || colon == 0) return {text, {}};
    std::string_view rest = std::string_view(text).substr(colon + 1);
    if (rest == "stroke") return {text.substr(0, colon), {}, true};
    double width = 0;
    if (files::take_number(rest, width) != std::errc{} || !rest.empty()) return {text, {}};
    return {text.substr(0, colon), width};
}

// The points of a .csv, each with the width that was given, or the number in its column radius.
// Without a header x and y come first.
std::vector<Outline> read_disks(Role role, const FileAndWidth& given) {
    const std::string option(name_of(role));
    const std::string bytes = files::read_whole(given.path);
    const std::string name = files::name_of(given.path);
    files::CsvRows rows(bytes, name);
    const std::vector<std::string>& names = rows.names();
    const files::PointColumns columns =
        names.empty() ? files::PointColumns() : files::PointColumns(names, rows.place());
    const auto radius = std::find_if(names.begin(), names.end(), [](const std::string& column) {
        return files::is_called(column, "radius");
    });
    if (!given.width && radius == names.end())
        throw BadRequest(option, shown(name),
                         "has no column radius: give FILE:WIDTH, the distance from its points");
    std::map<double, std::vector<PolygonRing>> by_radius;
    while (rows.next()) {
        if (rows.columns() < 2) files::refuse(rows.place(), "1 column: must have x and y");
        const Point point{rows.number(columns.x), rows.number(columns.y)};
        if (!domains::is_fair(point))
            files::refuse(rows.place(),
                          fmt::format("({}, {}): {}", point.x, point.y, domains::kFair));
        const double width = given.width
                                 ? *given.width
                                 : rows.number(static_cast<std::size_t>(radius - names.begin()));
        if (width < 0)
            files::refuse(rows.place(), fmt::format("radius {}: must be at least 0", width));
        if (width > 0) by_radius[width].push_back({point});
    }
    std::vector<Outline> all;
    all.reserve(by_radius.size());
    for (auto& [width, rings] : by_radius) all.push_back({{std::move(rings), {}}, role, width, {}});
    if (role == Role::near && all.empty())
        throw BadRequest(option, shown(name),
                         "must have a point with a distance over 0, or points may lie nowhere");
    return all;
}

// Calls read(), whose errors about the path shall name this option.
template <class Read>
Polygons read_for(const std::string& option, const Read& read) {
    try {
        return read();
    } catch (const BadRequest& error) {
        throw BadRequest(option, error.value(), error.reason());
    }
}

}  // namespace

std::string path_of_obstacles(const std::string& text) {
    return file_and_width(text).path;
}

std::vector<Outline> read_outlines(Role role, const std::string& text) {
    const std::string option(name_of(role));
    if (!has_distance(role))
        return {{read_for(option, [&] { return read_polygons(text); }), role, {}, {}}};
    const FileAndWidth given = file_and_width(text);
    const bool is_near = role == Role::near;
    if (given.width && !(*given.width > 0 && std::isfinite(*given.width)))
        throw BadRequest(option, shown(text),
                         std::string(is_near ? "the distance" : "the width") +
                             " must be a finite number over 0");
    if (given.is_of_strokes) {
        std::vector<Outline> all;
        for (domains::Strokes& strokes : domains::read_strokes(given.path, option))
            all.push_back({std::move(strokes.lines), role, strokes.distance, {}, true});
        return all;
    }
    if (given.path.ends_with(".csv")) return read_disks(role, given);
    Polygons lines = read_for(option, [&] { return read_lines(given.path); });
    if (!given.width)
        throw BadRequest(
            option, shown(text),
            is_near ? "needs a distance, as in FILE:2.5: how far points may be from its lines"
                    : "needs a width, as in FILE:2.5: how far points stay from its lines");
    return {{std::move(lines), role, *given.width, {}}};
}

}  // namespace lacuna::cli
