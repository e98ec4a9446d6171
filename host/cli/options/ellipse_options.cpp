// Options of ellipses, and how they become a field.
#include "cli/options/ellipse_options.h"

#include <CLI/App.hpp>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string_view>
#include <system_error>

#include "cli/options/options.h"
#include "files/parse.h"
#include "pictures/ellipses.h"

namespace lacuna::cli {
namespace {

// A:B@DEGREES: two radii, and the angle of the first one.
pictures::Radii radii_from(const std::string& text) {
    pictures::Radii radii{};
    std::string_view rest = text;
    const auto take = [&](double& number) {
        return files::take_number(rest, number) == std::errc{};
    };
    const auto take_sign = [&](char sign) {
        if (!rest.starts_with(sign)) return false;
        rest.remove_prefix(1);
        return true;
    };
    double degrees = 0;
    if (!take(radii.first) || !take_sign(':') || !take(radii.second) || !take_sign('@') ||
        !take(degrees) || !rest.empty())
        throw BadRequest("stretch", shown(text),
                         "must be two radii and an angle in degrees, such as 0.02:0.005@30");
    radii.angle = degrees * std::numbers::pi / 180;
    return radii;
}

}  // namespace

void add_ellipses(CLI::App& command, EllipseOptions& options) {
    command
        .add_option("--ellipses", options.path,
                    "An ellipse for each point instead of a disk: a .npy of rows x columns x 3 "
                    "numbers, two radii and the angle of the first one, in radians "
                    "counterclockwise from the x axis; --scale multiplies all radii (default 1)")
        ->type_name("FILE");
    command
        .add_option("--stretch", options.same,
                    "The same ellipse for all points: two radii, and the angle of the first one "
                    "in degrees counterclockwise from the x axis")
        ->type_name("A:B@DEGREES");
}

void check(const EllipseOptions& options) {
    if (!options.path.empty() && !options.same.empty())
        throw BadRequest("stretch", shown(options.same), "cannot be used with --ellipses");
}

Field read_ellipses(const EllipseOptions& options) {
    if (!options.path.empty()) return pictures::read_ellipses(options.path);
    Field field;
    field.columns = field.rows = 1;
    pictures::add_pixel(field, radii_from(options.same), "stretch", shown(options.same));
    return field;
}

nlohmann::ordered_json json_of(const EllipseOptions& options) {
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    if (!options.path.empty()) json["ellipses"] = options.path;
    if (!options.same.empty()) json["stretch"] = options.same;
    return json;
}

}  // namespace lacuna::cli
