// The format .npy of NumPy: an array of N x 2 numbers.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "files/little_endian.h"
#include "files/npy.h"
#include "files/parse.h"
#include "files/point_files.h"
#include "files/read_sets.h"

namespace lacuna::files {
namespace {

// x and y; with radius, x_mm, y_mm and radius_mm of dots; with a, b and angle of ellipses; with
// all.
constexpr std::array<std::uint64_t, 4> kColumns{2, 6, 5, 9};

template <class Number>
std::vector<Point> load_points(std::string_view data, const NpyHeader& header,
                               const std::string& name) {
    const std::uint64_t count = header.shape[0];
    const std::size_t columns = header.shape[1];
    const std::size_t whole = data.size() / (columns * sizeof(Number));
    if (count != whole || data.size() % (columns * sizeof(Number)) != 0)
        refuse(name, fmt::format("{} bytes of data: {} points of {} bytes each are announced",
                                 data.size(), count, columns * sizeof(Number)));
    // Distances in the array, counted in numbers: from one point to the next, and from x to y.
    const std::size_t step = header.fortran_order ? 1 : columns;
    const std::size_t to_y = header.fortran_order ? whole : 1;
    std::vector<Point> points(whole);
    for (std::size_t i = 0; i < whole; ++i) {
        const auto at = [&](std::size_t k) {
            return double{load_little_endian<Number>(data.substr(k * sizeof(Number)))};
        };
        points[i] = {at(i * step), at(i * step + to_y)};
        check_finite(points[i], i, name);
    }
    return points;
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
        const Point& point = set.points[i];
        append_little_endian(bytes, point.x);
        append_little_endian(bytes, point.y);
        for (const Column& column : columns) append_little_endian(bytes, column.values[i]);
        if (!layers.empty()) append_little_endian(bytes, static_cast<double>(layers[i]));
    }
    return bytes;
}

SetsOfFile decode_npy(std::string_view bytes, const std::string& name) {
    const NpyHeader header = take_npy_header(bytes, name);
    if (header.shape.size() != 2 ||
        std::find(kColumns.begin(), kColumns.end(), header.shape[1]) == kColumns.end())
        refuse(name, fmt::format("an array of shape {}: must be N x 2, N x 6 as --dot-size makes "
                                 "it, or N x 5 or N x 9 with --ellipse-columns",
                                 shape_text(header.shape)));
    if (header.descr == "<f8") return one_set(load_points<double>(bytes, header, name));
    if (header.descr == "<f4") return one_set(load_points<float>(bytes, header, name));
    refuse(name, fmt::format("numbers of type {}: must be '<f8' or '<f4', little-endian floats",
                             excerpt(header.descr)));
}

}  // namespace lacuna::files
