// Reads polygons; the extension of the file names the format.
#include <fmt/core.h>
#include <lacuna/domains.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/polling.h"
#include "domains/rings.h"
#include "files/parse.h"
#include "files/point_files.h"
#include "files/read_whole.h"

namespace lacuna {
namespace {

constexpr std::array<std::string_view, 5> kMeshes{"obj", "stl", "off", "gltf", "glb"};
constexpr std::string_view kAllowed = "must end in .svg, .svgz, .geojson, .geojsonl, .json or .txt";

Polygons decode_whole_svg(std::string_view bytes, const std::string& name, domains::Take take) {
    return domains::decode_svg(bytes, name, take);
}

struct Known {
    std::string_view name;
    Polygons (*decode)(std::string_view bytes, const std::string& name, domains::Take take);
};

constexpr std::array<Known, 6> kFormats{{{"svg", decode_whole_svg},
                                         {"svgz", decode_whole_svg},
                                         {"geojson", domains::decode_geojson},
                                         {"geojsonl", domains::decode_geojson},
                                         {"json", domains::decode_geojson},
                                         {"txt", domains::decode_rings}}};

// The part of the name after the last dot, in lower case.
std::string extension_of(const std::string& path) {
    const std::size_t dot = path.find_last_of("./");
    if (dot == std::string::npos || path[dot] != '.') return "";
    std::string extension = path.substr(dot + 1);
    std::transform(extension.begin(), extension.end(), extension.begin(), files::lower_case);
    return extension;
}

bool is_svg(std::string_view format) {
    return format == "svg" || format == "svgz";
}

const Known* find(std::string_view format) {
    const auto* known = std::find_if(kFormats.begin(), kFormats.end(),
                                     [format](const Known& one) { return one.name == format; });
    return known == kFormats.end() ? nullptr : known;
}

Polygons decode(std::string_view bytes, std::string_view format, const std::string& name,
                domains::Take take, std::string_view layer) {
    const Known* const known = find(format);
    if (known == nullptr)
        throw BadRequest("format", fmt::format("{:?}", format), "must be svg, geojson or txt");
    Polygons polygons = layer.empty() ? known->decode(bytes, name, take)
                                      : domains::decode_svg(bytes, name, take, layer);
    if (!polygons.rings.empty()) return polygons;
    const std::string where =
        layer.empty()
            ? ""
            : fmt::format(" in the layer {}, or it is hidden or in defs", files::excerpt(layer));
    if (take == domains::Take::insides)
        files::refuse(
            name, fmt::format("no polygon{}: there must be at least one, of three points or more",
                              where));
    files::refuse(name, fmt::format("no line and no outline{}: there must be one", where));
}

Polygons read(const std::string& path, const char* option, domains::Take take) {
    const auto [file, layer] = domains::file_and_layer(path);
    const std::string format = extension_of(file);
    const bool is_mesh = std::find(kMeshes.begin(), kMeshes.end(), format) != kMeshes.end();
    if (find(format) == nullptr)
        throw BadRequest(
            option, path,
            (is_mesh ? "is in space, but domains are flat: " : "") + std::string(kAllowed));
    return decode(files::read_whole(file), format, files::name_of(file), take, layer);
}

}  // namespace

domains::FileAndLayer domains::file_and_layer(const std::string& path) {
    const auto exists = [](const std::string& file) {
        std::error_code ignored;
        return std::filesystem::exists(file, ignored);
    };
    FileAndLayer parts{path, ""};
    for (std::size_t sharp = path.find('#'); sharp < path.size() - 1 && !exists(parts.file);
         sharp = path.find('#', sharp + 1)) {
        const FileAndLayer split{path.substr(0, sharp), path.substr(sharp + 1)};
        if (is_svg(extension_of(split.file)) && (parts.layer.empty() || exists(split.file)))
            parts = split;
    }
    return parts;
}

Polygons read_polygons(const std::string& path) {
    return read(path, "inside", domains::Take::insides);
}

Polygons decode_polygons(std::string_view bytes, std::string_view format, const std::string& name) {
    return decode(bytes, format, name, domains::Take::insides, {});
}

Polygons read_lines(const std::string& path) {
    return read(path, "avoid", domains::Take::lines);
}

std::vector<domains::Strokes> domains::read_strokes(const std::string& path,
                                                    const std::string& option) {
    const auto [file, layer] = file_and_layer(path);
    if (!is_svg(extension_of(file)))
        throw BadRequest(option, path + ":stroke",
                         "must be an .svg, which says how wide its strokes are");
    const std::string name = files::name_of(file);
    std::vector<Strokes> all = decode_strokes(files::read_whole(file), name, layer);
    if (all.empty())
        files::refuse(name, "no line with a stroke: there must be one, or give FILE:WIDTH");
    return all;
}

Polygons decode_lines(std::string_view bytes, std::string_view format, const std::string& name) {
    return decode(bytes, format, name, domains::Take::lines, {});
}

}  // namespace lacuna
