// The format .json, as it is written: as a stream, because a tree of millions of values would take
// gigabytes of memory. decode_json.cpp reads it.
#include <fmt/compile.h>
#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "base/polling.h"
#include "files/json_text.h"
#include "files/point_files.h"
#include "files/text_lines.h"

namespace lacuna::files {
namespace {

// For each level of a progressive order the number of its points, and the radius or scale at which
// they are maximal.
void append_levels(std::string& bytes, const Origin& origin) {
    bytes += "\"levels\":[";
    const char* separator = "";
    for (const Level& level : origin.levels) {
        bytes += fmt::format("{}{{\"count\":{},\"{}\":", separator, level.points,
                             origin.scale > 0 ? "scale" : "radius");
        append_json_number(bytes, level.size);
        bytes += '}';
        separator = ",";
    }
    bytes += "],\n";
}

void append_dots(std::string& bytes, const Dots& dots) {
    bytes += "\"dots\":{\"mm_per_unit\":";
    append_json_number(bytes, dots.millimetres_per_unit);
    bytes += ",\"left_mm\":";
    append_json_number(bytes, dots.left_mm);
    bytes += ",\"bottom_mm\":";
    append_json_number(bytes, dots.bottom_mm);
    bytes += ",\"radii\":[";
    const char* separator = "\n";
    for (const double radius : dots.radii) {
        bytes += separator;
        append_json_number(bytes, radius);
        separator = ",\n";
    }
    bytes += "]},\n";
}

void append_ellipses(std::string& bytes, std::span<const Ellipse> ellipses) {
    bytes += "\"ellipses\":[";
    const char* separator = "\n[";
    for (const Ellipse& ellipse : ellipses) {
        for (const double value : {ellipse.a, ellipse.b, ellipse.angle}) {
            bytes += separator;
            append_json_number(bytes, value);
            separator = ",";
        }
        separator = "],\n[";
    }
    bytes += ellipses.empty() ? "],\n" : "]],\n";
}

void append_more(std::string& bytes, std::span<const Column> columns) {
    for (const Column& column : columns) {
        // "radius" is the set's.
        const std::string_view name = column.name;
        bytes += fmt::format("\"{}\":[", name == "radius" ? "radii" : name);
        const char* separator = "";
        for (const double value : column.values) {
            bytes += separator;
            append_json_number(bytes, value);
            separator = ",\n";
        }
        bytes += "],\n";
    }
}

void append_layers(std::string& bytes, const PointSet& set) {
    const bool are_inks = set.layers_are == LayersAre::inks;
    bytes += are_inks ? "\"inks\":[" : "\"classes\":[";
    const char* separator = "";
    for (const Layer& layer : set.layers) {
        bytes += fmt::format("{}{{\"name\":{},\"colour\":\"{}\",\"count\":{}}}", separator,
                             quoted_json(layer.ink.name), hex_of(layer.ink.colour), layer.dots);
        separator = ",";
    }
    bytes += are_inks ? "],\"ink\":[" : "],\"class\":[";
    separator = "";
    for (const std::uint8_t layer : layers_of_points(set)) {
        fmt::format_to(std::back_inserter(bytes), FMT_COMPILE("{}{}"), separator, layer);
        separator = ",";
    }
    bytes += "],\n";
}

}  // namespace

// File names and names of other programs' classes need not be valid UTF-8.
std::string quoted_json(const std::string& text) {
    return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void append_json_number(std::string& bytes, double value) {
    ask_after(8);
    const std::size_t begin = bytes.size();
    fmt::format_to(std::back_inserter(bytes), FMT_COMPILE("{}"), value);
    if (bytes.find_first_of(".e", begin) == std::string::npos) bytes += ".0";
}

void append_origin(std::string& bytes, const Origin& origin) {
    bytes += fmt::format(
        ",\"mode\":\"{}\",\"seed\":{},\"maximal\":{},"
        "\"options\":{},\"program\":\"lacuna\",\"version\":\"{}\"",
        name_of(origin.mode.value_or(Mode::exact)), origin.seed, origin.maximal.value_or(false),
        origin.options.empty() ? "{}" : origin.options, origin.version);
    if (!origin.command.empty()) bytes += ",\"command\":" + quoted_json(origin.command);
}

std::string encode_json(const PointSet& set) {
    std::string bytes = with_room_for("{\"width\":", set.points.size());
    append_json_number(bytes, set.domain.width);
    bytes += ",\"height\":";
    append_json_number(bytes, set.domain.height);
    if (set.domain.has_corner()) {
        bytes += ",\"x0\":";
        append_json_number(bytes, set.domain.x0);
        bytes += ",\"y0\":";
        append_json_number(bytes, set.domain.y0);
    }
    bytes += ",\"radius\":";
    append_json_number(bytes, set.radius);
    if (set.origin != nullptr && set.origin->scale > 0) {
        bytes += ",\"scale\":";
        append_json_number(bytes, set.origin->scale);
    }
    bytes += fmt::format(",\"boundary\":\"{}\"", set.domain.wraps() ? "torus" : "box");
    if (set.origin != nullptr)
        append_origin(bytes, *set.origin);
    else if (set.is_relaxed)
        bytes += ",\"mode\":\"stratified\"";
    bytes += fmt::format(",\"count\":{},", set.points.size());
    if (set.origin != nullptr && !set.origin->levels.empty()) append_levels(bytes, *set.origin);
    if (set.dots != nullptr) append_dots(bytes, *set.dots);
    if (set.writes_ellipses) append_ellipses(bytes, set.ellipses);
    append_more(bytes, set.more);
    if (!set.layers.empty()) append_layers(bytes, set);
    bytes += "\"points\":[";
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

}  // namespace lacuna::files
