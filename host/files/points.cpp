// Point sets as bytes: the text and array formats. A reader gets back the very same doubles.
#include <fmt/compile.h>
#include <fmt/format.h>

#include <cstddef>
#include <iterator>
#include <span>
#include <string>

#include "drawing/picture.h"
#include "files/little_endian.h"
#include "files/point_files.h"

namespace lacuna::files {
namespace {

// A line of text with two numbers of 17 significant digits is seldom longer.
constexpr std::size_t kUsualBytesPerLine = 48;

std::string with_room_for(std::string header, std::size_t lines) {
    header.reserve(header.size() + lines * kUsualBytesPerLine);
    return header;
}

std::string encode_txt(std::span<const Point> points) {
    std::string bytes = with_room_for("", points.size());
    for (const Point& point : points)
        fmt::format_to(std::back_inserter(bytes), FMT_COMPILE("{:.17g} {:.17g}\n"), point.x,
                       point.y);
    return bytes;
}

std::string encode_csv(std::span<const Point> points) {
    std::string bytes = with_room_for("x,y\n", points.size());
    for (const Point& point : points)
        fmt::format_to(std::back_inserter(bytes), FMT_COMPILE("{:.17g},{:.17g}\n"), point.x,
                       point.y);
    return bytes;
}

std::string encode_ply(std::span<const Point> points) {
    std::string bytes = with_room_for(fmt::format("ply\n"
                                                  "format ascii 1.0\n"
                                                  "element vertex {}\n"
                                                  "property double x\n"
                                                  "property double y\n"
                                                  "property double z\n"
                                                  "end_header\n",
                                                  points.size()),
                                      points.size());
    for (const Point& point : points)
        fmt::format_to(std::back_inserter(bytes), FMT_COMPILE("{:.17g} {:.17g} 0\n"), point.x,
                       point.y);
    return bytes;
}

// The shortest digits that give back `value`, with ".0" after whole numbers: readers which tell 1
// from 1.0 then see a float, and -0.0 keeps its sign.
void append_json_number(std::string& bytes, double value) {
    const std::size_t begin = bytes.size();
    fmt::format_to(std::back_inserter(bytes), FMT_COMPILE("{}"), value);
    if (bytes.find_first_of(".e", begin) == std::string::npos) bytes += ".0";
}

// Without a JSON library: a tree of millions of values would take gigabytes.
std::string encode_json(const PointSet& set) {
    std::string bytes = with_room_for("{\"width\":", set.points.size());
    append_json_number(bytes, set.width);
    bytes += ",\"height\":";
    append_json_number(bytes, set.height);
    bytes += ",\"radius\":";
    append_json_number(bytes, set.radius);
    bytes += fmt::format(",\"count\":{},\"points\":[", set.points.size());
    const char* separator = "\n[";
    for (const Point& point : set.points) {
        bytes += separator;
        append_json_number(bytes, point.x);
        bytes += ',';
        append_json_number(bytes, point.y);
        bytes += ']';
        separator = ",\n[";
    }
    return bytes + "]}\n";
}

// NumPy's .npy format, version 1.0: magic, version, length of the header, header, data.
std::string npy_header(std::size_t count) {
    constexpr std::size_t kAlignment = 64;  // of the data, so that a reader may map the file
    constexpr std::size_t kBeforeText = 10;
    std::string text =
        fmt::format("{{'descr': '<f8', 'fortran_order': False, 'shape': ({}, 2), }}", count);
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

std::string encode_npy(std::span<const Point> points) {
    std::string bytes = npy_header(points.size());
    bytes.reserve(bytes.size() + points.size() * 2 * sizeof(double));
    for (const Point& point : points) {
        append_little_endian(bytes, point.x);
        append_little_endian(bytes, point.y);
    }
    return bytes;
}

}  // namespace

std::string encode(const PointSet& set, Format format) {
    switch (format) {
        case Format::txt:
            return encode_txt(set.points);
        case Format::csv:
            return encode_csv(set.points);
        case Format::npy:
            return encode_npy(set.points);
        case Format::ply:
            return encode_ply(set.points);
        case Format::json:
            return encode_json(set);
        case Format::svg:
        case Format::pdf:
        case Format::png:
            return drawing::draw(set, format);
    }
    throw FileError("no such format: " + std::to_string(static_cast<int>(format)));
}

}  // namespace lacuna::files
