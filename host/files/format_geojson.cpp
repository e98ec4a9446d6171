// The format .geojson: a point of a FeatureCollection on each line, with its columns as properties.
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/polling.h"
#include "files/json_text.h"
#include "files/parse.h"
#include "files/point_columns.h"
#include "files/point_files.h"
#include "files/read_points.h"
#include "files/text_lines.h"

namespace lacuna::files {

std::string encode_geojson(const PointSet& set) {
    const std::vector<Column> columns = columns_of(set);
    const std::vector<std::uint8_t> layers = layers_of_points(set);
    const char* const of_layer = set.layers_are == LayersAre::inks ? "ink" : "class";
    std::string bytes = with_room_for(R"({"type":"FeatureCollection","features":[)",
                                      (3 + columns.size()) * set.points.size());
    for (std::size_t i = 0; i < set.points.size(); ++i) {
        ask_after(16);
        bytes += i == 0 ? "\n" : ",\n";
        bytes += R"({"type":"Feature","geometry":{"type":"Point","coordinates":[)";
        append_json_number(bytes, set.points[i].x);
        bytes += ',';
        append_json_number(bytes, set.points[i].y);
        bytes += R"(]},"properties":{)";
        const char* separator = "";
        for (const Column& column : columns) {
            bytes += fmt::format("{}\"{}\":{:.9g}", separator, column.name, column.values[i]);
            separator = ",";
        }
        if (!layers.empty())
            bytes += fmt::format("{}\"{}\":{}", separator, of_layer,
                                 quoted_json(set.layers[layers[i]].ink.name));
        bytes += "}}";
    }
    return bytes + "\n]}\n";
}

namespace {

using Json = nlohmann::json;

// The value of a key; null if there is none.
const Json& property_of(const Json& object, const char* key) {
    static const Json null;
    return object.is_object() && object.contains(key) ? object[key] : null;
}

// The class, the ink and the ellipse of a point; other properties are not read.
void take_properties(const Json& properties, const std::string& place, PointsOfFile& file) {
    for (const auto& [key, layers] :
         {std::pair{"class", &file.classes}, std::pair{"ink", &file.inks}}) {
        const Json& value = property_of(properties, key);
        if (value.is_null()) continue;
        if (!value.is_string()) refuse(place, fmt::format("its {} must be a text", key));
        layers->of_point.push_back(place_among(layers->names, value.get<std::string>(), place));
    }
    const Json& a = property_of(properties, "a");
    const Json& b = property_of(properties, "b");
    const Json& angle = property_of(properties, "angle");
    const bool is_ellipse = a.is_number() && b.is_number() && angle.is_number();
    if (is_ellipse)
        file.ellipses.push_back({a.get<double>(), b.get<double>(), angle.get<double>()});
    const Json& radius = property_of(properties, "radius");
    const bool has_radius =
        radius.is_number() && properties.contains("class") && !properties.contains("x_mm");
    if (has_radius) file.radii.push_back(radius.get<double>());
    std::vector<std::string>& others = file.other_columns;
    if (!properties.is_object()) return;
    for (const auto& [key, value] : properties.items())
        if (key != "class" && key != "ink" && !(has_radius && key == "radius") &&
            !(is_ellipse && (key == "a" || key == "b" || key == "angle")) &&
            std::find(others.begin(), others.end(), key) == others.end())
            others.push_back(key);
}

}  // namespace

PointsOfFile decode_geojson(std::string_view bytes, const std::string& name) {
    const Json json = Json::parse(bytes, nullptr, false);
    const Json& features = property_of(json, "features");
    if (!features.is_array()) refuse(name, "must be a FeatureCollection of points");
    PointsOfFile file;
    for (const Json& feature : features) {
        ask_after(64);
        const std::string place = fmt::format("{}: feature {}", name, file.points.size());
        const Json& geometry = property_of(feature, "geometry");
        const Json& at = property_of(geometry, "coordinates");
        if (property_of(geometry, "type") != "Point" || !at.is_array() || at.size() != 2 ||
            !at[0].is_number() || !at[1].is_number())
            refuse(place, "must be a Point with two coordinates");
        file.points.push_back({at[0].get<double>(), at[1].get<double>()});
        take_properties(property_of(feature, "properties"), place, file);
    }
    for (const std::size_t count : {file.classes.of_point.size(), file.inks.of_point.size(),
                                    file.ellipses.size(), file.radii.size()})
        if (count != 0 && count != file.points.size())
            refuse(name, "some points have a class, ink, ellipse or radius, and some have none");
    return file;
}

}  // namespace lacuna::files
