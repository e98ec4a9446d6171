// The format .npy of NumPy: an array with a row for each point.
#include <fmt/core.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/polling.h"
#include "files/little_endian.h"
#include "files/npy.h"
#include "files/npy_numbers.h"
#include "files/parse.h"
#include "files/point_columns.h"
#include "files/point_files.h"
#include "files/read_points.h"

namespace lacuna::files {
namespace {

// The columns of an array, which has no names: x and y; with z; as this program writes them, with
// the sizes and places of dots, with ellipses, or with both.
const std::vector<std::string>* columns_of_array(std::uint64_t count) {
    static const std::array<std::vector<std::string>, 5> known{
        {{"x", "y"},
         {"x", "y", "z"},
         {"x", "y", "a", "b", "angle"},
         {"x", "y", "radius", "x_mm", "y_mm", "radius_mm"},
         {"x", "y", "radius", "x_mm", "y_mm", "radius_mm", "a", "b", "angle"}}};
    for (const std::vector<std::string>& names : known)
        if (names.size() == count) return &names;
    return nullptr;
}

template <class Number>
PointsOfFile load_set(std::string_view data, std::endian order, const NpyHeader& header,
                      const PointColumns& columns, const std::string& name) {
    const std::uint64_t count = header.shape[0];
    const std::size_t width = header.shape[1];
    const std::size_t whole = data.size() / (width * sizeof(Number));
    if (count != whole || data.size() % (width * sizeof(Number)) != 0)
        refuse(name, fmt::format("{} bytes of data: {} points of {} bytes each are announced",
                                 data.size(), count, width * sizeof(Number)));
    // Distances in the array, counted in numbers: from one point to the next, and from x to y.
    const std::size_t step = header.fortran_order ? 1 : width;
    const std::size_t across = header.fortran_order ? whole : 1;
    PointsOfFile file{.points = std::vector<Point>(whole)};
    std::vector<Point>& points = file.points;
    for (std::size_t i = 0; i < whole; ++i) {
        const auto at = [&](std::size_t column) {
            const std::size_t index = i * step + column * across;
            return value_of(load<Number>(data.substr(index * sizeof(Number)), order));
        };
        points[i] = {at(columns.x), at(columns.y)};
        check_finite(points[i], i, name);
        if (columns.z) file.z.push_back(at(*columns.z));
        if (columns.a)
            file.ellipses.push_back({at(*columns.a), at(*columns.b), at(*columns.angle)});
    }
    file.other_columns = columns.others;
    return file;
}

}  // namespace

// NumPy's .npy format, version 1.0: magic, version, length of the header, header, data.
std::string npy_header(std::size_t count, int columns) {
    constexpr std::size_t kAlignment = 64;  // the data's, so that a reader may map it
    constexpr std::size_t kBeforeText = 10;
    std::string text = fmt::format(
        "{{'descr': '<f8', 'fortran_order': False, 'shape': ({}, {}), }}", count, columns);
    const std::size_t unpadded = kBeforeText + text.size() + 1;
    text.append((kAlignment - unpadded % kAlignment) % kAlignment, ' ');
    text.push_back('\n');

    std::string header = "\x93NUMPY";
    header.push_back('\x01');
    header.push_back('\x00');
    header.push_back(static_cast<char>(text.size() & 0xffU));
    header.push_back(static_cast<char>(text.size() >> 8U));
    return header + text;
}

std::string encode_npy(const PointSet& set) {
    const std::vector<Column> columns = columns_of(set);
    const std::vector<std::uint8_t> layers = layers_of_points(set);
    const std::size_t numbers = 2 + columns.size() + (layers.empty() ? 0 : 1);
    std::string bytes = npy_header(set.points.size(), static_cast<int>(numbers));
    bytes.reserve(bytes.size() + set.points.size() * numbers * sizeof(double));
    for (std::size_t i = 0; i < set.points.size(); ++i) {
        ask_after(16);
        const Point& point = set.points[i];
        append_little_endian(bytes, point.x);
        append_little_endian(bytes, point.y);
        for (const Column& column : columns) append_little_endian(bytes, column.values[i]);
        if (!layers.empty()) append_little_endian(bytes, static_cast<double>(layers[i]));
    }
    return bytes;
}

PointsOfFile decode_npy(std::string_view bytes, const std::string& name) {
    const NpyHeader header = take_npy_header(bytes, name);
    const auto* const names =
        header.shape.size() == 2 ? columns_of_array(header.shape[1]) : nullptr;
    if (names == nullptr)
        refuse(name,
               fmt::format("an array of shape {}: must be N x 2, N x 3 with the same z in all "
                           "rows, N x 6 as --dot-size makes it, or N x 5 or N x 9 with "
                           "--ellipse-columns",
                           shape_text(header.shape)));
    const PointColumns columns(*names, name);
    return with_npy_numbers(header.descr, name, [&](auto number, std::endian order) {
        return load_set<decltype(number)>(bytes, order, header, columns, name);
    });
}

}  // namespace lacuna::files
