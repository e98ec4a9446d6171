// The format .csv: a header line, then the fields of a point on each line.
#include <fmt/compile.h>
#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/polling.h"
#include "files/csv_rows.h"
#include "files/parse.h"
#include "files/point_columns.h"
#include "files/point_files.h"
#include "files/read_points.h"
#include "files/text_lines.h"

namespace lacuna::files {
namespace {

// A name as a field: in quotes if it has a character that has a meaning in a .csv.
std::string field_of(const std::string& name) {
    if (name.find_first_of(",;\t\"") == std::string::npos) return name;
    std::string field = "\"";
    for (const char c : name) field.append(c == '"' ? 2 : 1, c);
    return field + '"';
}

// The name in a field, whose quotes are written twice.
std::string name_in(std::string_view field) {
    std::string name;
    for (std::size_t i = 0; i < field.size(); ++i) {
        name += field[i];
        if (field[i] == '"') ++i;
    }
    return name;
}

}  // namespace

std::string encode_csv(const PointSet& set) {
    const std::vector<Column> columns = columns_of(set);
    const std::vector<std::uint8_t> layers = layers_of_points(set);
    std::string header = "x,y";
    for (const Column& column : columns) (header += ',') += column.name;
    if (!layers.empty()) header += set.layers_are == LayersAre::inks ? ",ink" : ",class";
    std::string bytes =
        with_room_for(header + '\n', (1 + (columns.size() + 3) / 4) * set.points.size());
    for (std::size_t i = 0; i < set.points.size(); ++i) {
        ask_after(16);
        const Point& point = set.points[i];
        fmt::format_to(std::back_inserter(bytes), FMT_COMPILE("{:.17g},{:.17g}"), point.x, point.y);
        for (const Column& column : columns)
            fmt::format_to(std::back_inserter(bytes), FMT_COMPILE(",{:.9g}"), column.values[i]);
        if (!layers.empty()) (bytes += ',') += field_of(set.layers[layers[i]].ink.name);
        bytes += '\n';
    }
    return bytes;
}

PointsOfFile decode_csv(std::string_view bytes, const std::string& name) {
    CsvRows rows(bytes, name);
    PointsOfFile file;
    std::vector<Point>& points = file.points;
    const PointColumns columns =
        rows.names().empty() ? PointColumns() : PointColumns(rows.names(), rows.place());
    while (rows.next()) {
        if (rows.names().empty() && rows.columns() != 2)
            refuse(rows.place(), fmt::format("{} column{}: must be two, or the first line must "
                                             "call one of them x and one y",
                                             rows.columns(), rows.columns() == 1 ? "" : "s"));
        const auto number = [&](std::size_t column) { return rows.number(column); };
        if (columns.z) file.z.push_back(number(*columns.z));
        points.push_back({number(columns.x), number(columns.y)});
        if (columns.radius) file.radii.push_back(number(*columns.radius));
        if (columns.a)
            file.ellipses.push_back(
                {number(*columns.a), number(*columns.b), number(*columns.angle)});
        for (const auto& [column, layers] :
             {std::pair{columns.of_class, &file.classes}, std::pair{columns.ink, &file.inks}})
            if (column)
                layers->of_point.push_back(
                    place_among(layers->names, name_in(rows.field(*column)), rows.place()));
    }
    file.other_columns = columns.others;
    return file;
}

}  // namespace lacuna::files
