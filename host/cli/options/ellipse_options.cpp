// Options of ellipses, and how they become a field.
#include "cli/options/domain_options.h"

#include <nlohmann/json.hpp>
#include <numbers>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/number_text.h"
#include "files/parse.h"
#include "pictures/ellipses.h"

namespace lacuna::cli {

Ellipse ellipse_from(const std::string& text) {
    Ellipse ellipse{};
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
    if (!take(ellipse.a) || !take_sign(':') || !take(ellipse.b) || !take_sign('@') ||
        !take(degrees) || !rest.empty())
        throw BadRequest("stretch", shown(text),
                         "must be two radii and an angle in degrees, such as 0.02:0.005@30");
    ellipse.angle = degrees * std::numbers::pi / 180;
    if (!pictures::is_allowed(ellipse))
        throw BadRequest("stretch", shown(text), pictures::kAllowedEllipse);
    return ellipse;
}

Field read_ellipses(const EllipseOptions& options) {
    if (!options.path.empty()) return pictures::read_ellipses(options.path);
    return pictures::field_of(1, 1, std::vector{ellipse_from(options.same)});
}

void check_ellipse_columns(bool is_given, const std::vector<Output>& outputs) {
    if (is_given && !loss_of_columns(outputs).empty())
        throw BadRequest("ellipse-columns", "with .txt",
                         "the ellipse of each point " + loss_of_columns(outputs));
}

std::vector<Ellipse> ellipses_of(const Request& request, const Result& result) {
    if (request.field == nullptr || request.field->stretches.empty()) return {};
    return lacuna::ellipses_of(result.points, *request.field, result.scale, request.domain);
}

nlohmann::ordered_json json_of(const EllipseOptions& options) {
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    if (!options.path.empty()) json["ellipses"] = options.path;
    if (!options.same.empty()) json["stretch"] = options.same;
    return json;
}

}  // namespace lacuna::cli
