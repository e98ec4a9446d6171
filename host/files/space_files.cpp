// Writes sets in space.
#include "files/space_files.h"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <iterator>
#include <string_view>
#include <utility>

#include "base/number_text.h"
#include "base/polling.h"
#include "files/json_text.h"
#include "files/little_endian.h"
#include "files/npy.h"
#include "files/text_lines.h"

namespace lacuna::files {
namespace {

constexpr std::string_view kFormatsInSpace = ".txt .csv .npy .ply .json .png";

// The coordinates of each point with `between` between them; then the normal and the triangle, if
// that is wanted and the set has them.
std::string lines_of(const SetInSpace& set, std::string header, std::string_view between,
                     bool has_columns) {
    std::string bytes = with_room_for(std::move(header), 2 * set.points.size());
    const auto end = std::back_inserter(bytes);
    for (std::size_t i = 0; i < set.points.size(); ++i) {
        ask_after(16);
        const auto& [x, y, z] = set.points[i];
        fmt::format_to(end, FMT_COMPILE("{:.17g}{}{:.17g}{}{:.17g}"), x, between, y, between, z);
        if (has_columns && set.mesh != nullptr) {
            const bool is_kept = i < set.kept();
            const Point3 normal = is_kept ? Point3{} : set.normals[i - set.kept()];
            for (const double part : {normal.x, normal.y, normal.z})
                fmt::format_to(end, FMT_COMPILE("{}{:.9g}"), between, part);
            fmt::format_to(end, FMT_COMPILE("{}{}"), between,
                           is_kept ? -1 : std::int64_t{set.triangles[i - set.kept()]});
        }
        bytes += '\n';
    }
    return bytes;
}

std::string csv_of(const SetInSpace& set) {
    return lines_of(set, set.mesh != nullptr ? "x,y,z,nx,ny,nz,triangle\n" : "x,y,z\n", ",", true);
}

std::string ply_of(const SetInSpace& set) {
    std::string header =
        fmt::format("ply\nformat ascii 1.0\nelement vertex {}\n", set.points.size());
    for (const std::string_view name : {"x", "y", "z", "nx", "ny", "nz"})
        if (name.size() == 1 || set.mesh != nullptr)
            header += fmt::format("property double {}\n", name);
    if (set.mesh != nullptr) header += "property int triangle\n";
    return lines_of(set, header + "end_header\n", " ", true);
}

std::string npy_of(const SetInSpace& set) {
    std::string bytes = npy_header(set.points.size(), 3);
    for_each_polled(set.points.size(), ask, [&](std::size_t i) {
        for (const double one : {set.points[i].x, set.points[i].y, set.points[i].z})
            append_little_endian(bytes, one);
    });
    return bytes;
}

void append_triples(std::string& bytes, std::string_view name, std::size_t before,
                    std::span<const Point3> triples) {
    bytes += fmt::format("\"{}\":[", name);
    const char* separator = "\n[";
    for (std::size_t i = 0; i < before + triples.size(); ++i) {
        const Point3 triple = i < before ? Point3{} : triples[i - before];
        for (const double one : {triple.x, triple.y, triple.z}) {
            bytes += separator;
            append_json_number(bytes, one);
            separator = ",";
        }
        separator = "],\n[";
    }
    bytes += before + triples.size() == 0 ? "]" : "]]";
}

std::string json_of(const SetInSpace& set) {
    std::string bytes = with_room_for("{\"radius\":", 3 * set.points.size());
    append_json_number(bytes, set.radius);
    if (set.volume != nullptr) {
        const auto& [width, height, depth, boundary] = *set.volume;
        for (const auto& [name, side] :
             {std::pair{"width", width}, {"height", height}, {"depth", depth}}) {
            bytes += fmt::format(",\"{}\":", name);
            append_json_number(bytes, side);
        }
        bytes += fmt::format(",\"boundary\":\"{}\"", boundary == Boundary::torus ? "torus" : "box");
    }
    append_origin(bytes, *set.origin);
    bytes += fmt::format(",\"count\":{},", set.points.size());
    if (set.mesh != nullptr) {
        append_triples(bytes, "normals", set.kept(), set.normals);
        bytes += ",\n\"triangles\":[";
        for (std::size_t i = 0; i < set.points.size(); ++i) {
            const bool is_kept = i < set.kept();
            fmt::format_to(std::back_inserter(bytes), FMT_COMPILE("{}{}"), i == 0 ? "" : ",",
                           is_kept ? -1 : std::int64_t{set.triangles[i - set.kept()]});
        }
        bytes += "],\n";
    }
    append_triples(bytes, "points", 0, set.points);
    return bytes + "}\n";
}

}  // namespace

void check_in_space(const Format& format, const std::string& path) {
    const std::string known = fmt::format("{} ", kFormatsInSpace);
    if (known.find(fmt::format("{} ", format.extension)) == std::string::npos)
        throw BadRequest(
            "output", shown(path),
            fmt::format("has no place for three coordinates: must be one of {}", kFormatsInSpace));
}

std::string encode(const SetInSpace& set, const Format& format) {
    check_in_space(format, std::string(format.extension));
    const std::string_view name = format.name();
    if (name == "txt") return lines_of(set, "", " ", false);
    if (name == "csv") return csv_of(set);
    if (name == "npy") return npy_of(set);
    if (name == "ply") return ply_of(set);
    return json_of(set);
}

}  // namespace lacuna::files
