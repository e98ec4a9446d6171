// Compares the options of a command with those that a .json says its set was made with.
#include "base/number_text.h"
#include "cli/options/domain_options.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>

#include "cli/reports/report.h"
#include "cli/terminal/run_program.h"
#include "files/parse.h"

namespace lacuna::cli {
namespace {

[[noreturn]] void ask(const std::string& name, const std::string& option, const std::string& value,
                      const char* or_else) {
    throw BadUsage(fmt::format("{}: made with --{}{}: give that too{}", name, option,
                               value == "true" ? "" : " " + shown(value), or_else));
}

// A value as files::Origin::values has it.
std::string value_text(const Json& value) {
    if (value.is_boolean()) return value.get<bool>() ? "true" : "";
    if (value.is_number()) return fmt::format("{}", value.get<double>());
    std::string text;
    for (const Json& one : value) text += (text.empty() ? "" : ":") + value_text(one);
    return text;
}

std::optional<double> number_of(const files::Origin& origin, const char* option) {
    const auto found = origin.values.find(option);
    if (found == origin.values.end()) return std::nullopt;
    std::string_view text = found->second;
    double number = 0;
    if (files::take_number(text, number) != std::errc{} || !text.empty()) return std::nullopt;
    return number;
}

}  // namespace

void ask_for_files(const CommandLine& line, const DomainOptions& options, bool distances_only,
                   const files::Origin& origin, const std::string& name) {
    // The file of a set of disks holds its least radius, but the radius of an ellipse depends on
    // the direction.
    const bool has_ellipses = origin.values.contains("ellipses") || origin.values.contains("along");
    if (distances_only && !has_ellipses) return;
    const auto ask_for = [&](const std::string& key, std::string_view option) {
        const auto found = origin.values.find(key);
        if (found == origin.values.end() || line.has(option)) return;
        ask(name, std::string(option), found->second, has_ellipses ? "" : ", or --distances-only");
    };
    const std::vector<const options::Option*> rows = options::options_of(line.command);
    for (const options::Option* row : rows)
        if (row->names_a_file() && !row->is_argument() && row->name != "keep")
            ask_for(row->key(), row->name);
    ask_for("image", "field");  // of stipple
    if (number_of(origin, "neighbours").value_or(0) > 0) ask_for("keep", "keep");
    if (options.field.path.empty()) return;
    Picture any;
    const Targets readings = targets_of(any);  // of the options that say how a picture is read
    const Json own = json_of_importance(options.field.importance);
    for (const options::Option* row : rows) {
        const auto found = origin.values.find(row->key());
        if (!readings.contains(row->name) || found == origin.values.end() || line.has(row->name))
            continue;
        if (!own.contains(row->key()) || value_text(own.at(row->key())) != found->second)
            ask(name, std::string(row->name), found->second, "");
    }
}

std::shared_ptr<const Field> use_values(const CommandLine& line, const files::Origin& origin,
                                        Request& request, DomainOptions& options) {
    std::shared_ptr<const Field> field;
    const auto stretch = origin.values.find("stretch");
    if (request.field == nullptr && stretch != origin.values.end()) {
        EllipseOptions same;
        same.same = stretch->second;
        field = std::make_shared<const Field>(read_ellipses(same));
        request.field = field.get();
        if (!request.scale) request.scale = 1;
    }
    if (!line.has("scale") && request.field != nullptr) {
        const double scale =
            origin.scale > 0 ? origin.scale : number_of(origin, "scale").value_or(0);
        if (scale > 0) request.scale = scale;
    }
    Classes& classes = request.classes;
    const bool by_priority = classes.by_priority;
    if (classes.names.empty()) classes = origin.classes;
    classes.by_priority = by_priority || origin.values.contains("priority");
    if (!line.has("border") && !line.has("inside-by-radius")) {
        request.places.border = number_of(origin, "border").value_or(0);
        if (classes.names == origin.classes.names) request.places.borders = origin.borders;
        options.inside_by_radius = origin.values.contains("inside_by_radius");
    }
    if (!options.edge) options.edge = number_of(origin, "edge");
    return field;
}

std::size_t kept_in(const files::PointsOfFile& file) {
    const double kept = number_of(file.origin, "kept").value_or(0);
    const auto most = static_cast<double>(file.points.size());
    return static_cast<std::size_t>(std::clamp(std::floor(kept), 0.0, most));
}

}  // namespace lacuna::cli
