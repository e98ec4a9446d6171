// The table of formats, and the search for a format by its name.
#include "files/formats.h"

#include <fmt/core.h>
#include <lacuna/lacuna.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "files/parse.h"
#include "files/point_files.h"
#include "files/read_points.h"

namespace lacuna::files {

// Each of these functions stands in its format's file: encode_txt in format_txt.cpp. Those of
// pictures stand in drawing/picture.cpp.
std::string encode_txt(const PointSet& set);
std::string encode_csv(const PointSet& set);
std::string encode_npy(const PointSet& set);
std::string encode_ply(const PointSet& set);
std::string encode_geojson(const PointSet& set);
std::string encode_json(const PointSet& set);
std::string encode_svg(const PointSet& set);
std::string encode_pdf(const PointSet& set);
std::string encode_png(const PointSet& set);
PointsOfFile decode_txt(std::string_view bytes, const std::string& name);
PointsOfFile decode_csv(std::string_view bytes, const std::string& name);
PointsOfFile decode_npy(std::string_view bytes, const std::string& name);
PointsOfFile decode_ply(std::string_view bytes, const std::string& name);
PointsOfFile decode_geojson(std::string_view bytes, const std::string& name);
PointsOfFile decode_json(std::string_view bytes, const std::string& name);

namespace {

constexpr std::array<Format, 9> kFormats{{
    {".txt", encode_txt, decode_txt, std::nullopt, false},
    {".csv", encode_csv, decode_csv},
    {".npy", encode_npy, decode_npy},
    {".ply", encode_ply, decode_ply},
    {".geojson", encode_geojson, decode_geojson},
    {".json", encode_json, decode_json},
    {".svg", encode_svg, nullptr, Medium::svg},
    {".pdf", encode_pdf, nullptr, Medium::pdf},
    {".png", encode_png, nullptr, Medium::png},
}};

std::string in_lower_case(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(), lower_case);
    return result;
}

}  // namespace

std::string encode(const PointSet& set, const Format& format) {
    const char* const each =
        !set.layers.empty()
            ? set.layers_are == LayersAre::inks ? "ink of each dot" : "class of each point"
        : set.writes_ellipses ? "ellipse of each point"
                              : nullptr;
    if (!format.has_columns && each != nullptr)
        throw BadRequest(
            "output", std::string(format.extension),
            fmt::format("has no place for the {}: must be one of {}", each, column_extensions()));
    return format.encode(set);
}

std::span<const Format> formats() {
    return kFormats;
}

const Format* find_format(std::string_view name) {
    const std::string wanted = in_lower_case(name);
    const auto* const found =
        std::find_if(kFormats.begin(), kFormats.end(),
                     [&](const Format& format) { return format.name() == wanted; });
    return found == kFormats.end() ? nullptr : found;
}

const Format* find_format_of(const std::string& path) {
    const std::string extension = std::filesystem::path(path).extension().string();
    return extension.empty() ? nullptr : find_format(extension.substr(1));
}

const Format& format_of(const std::string& path) {
    const Format* const format = path == "-" ? find_format("txt") : find_format_of(path);
    if (format == nullptr)
        throw BadRequest("output", path, "the extension must be one of " + written_extensions());
    return *format;
}

std::string extensions(const std::function<bool(const Format&)>& is_wanted) {
    std::string list;
    for (const Format& format : kFormats)
        if (is_wanted(format)) list.append(list.empty() ? "" : " ").append(format.extension);
    return list;
}

std::string written_extensions() {
    return extensions([](const Format&) { return true; });
}

std::string read_extensions() {
    return extensions([](const Format& format) { return format.decode != nullptr; });
}

std::string column_extensions() {
    return extensions([](const Format& format) { return !format.medium && format.has_columns; });
}

std::string picture_extensions() {
    return extensions([](const Format& format) { return format.medium.has_value(); });
}

}  // namespace lacuna::files
