// Columns that files have besides the coordinates.
#include <cstddef>
#include <vector>

#include "base/polling.h"
#include "files/point_files.h"

namespace lacuna::files {

std::vector<Column> columns_of(const PointSet& set) {
    std::vector<Column> columns;
    const auto add = [&](const char* name, const auto& value) {
        std::vector<double>& values = columns.emplace_back(Column{name, {}}).values;
        for_each_polled(set.points.size(), ask, [&](std::size_t i) { values.push_back(value(i)); });
    };
    if (const Dots* const dots = set.dots) {
        add("radius", [&](std::size_t i) { return dots->radii[i]; });
        add("x_mm", [&](std::size_t i) { return dots->x_mm(set.points[i]); });
        add("y_mm", [&](std::size_t i) { return dots->y_mm(set.points[i]); });
        add("radius_mm", [&](std::size_t i) { return dots->radius_mm(i); });
    }
    if (set.writes_ellipses) {
        add("a", [&](std::size_t i) { return set.ellipses[i].a; });
        add("b", [&](std::size_t i) { return set.ellipses[i].b; });
        add("angle", [&](std::size_t i) { return set.ellipses[i].angle; });
    }
    columns.insert(columns.end(), set.more.begin(), set.more.end());
    return columns;
}

Column radius_of_each(std::span<const std::uint8_t> class_of_point,
                      std::span<const double> radii_of_classes) {
    Column column{"radius", {}};
    column.values.reserve(class_of_point.size());
    for (const std::uint8_t own : class_of_point) column.values.push_back(radii_of_classes[own]);
    return column;
}

}  // namespace lacuna::files
