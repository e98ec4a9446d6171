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

// A value as files::SetsOfFile::options has it.
std::string value_text(const Json& value) {
    if (value.is_boolean()) return value.get<bool>() ? "true" : "";
    if (value.is_number()) return fmt::format("{}", value.get<double>());
    std::string text;
    for (const Json& one : value) text += (text.empty() ? "" : ":") + value_text(one);
    return text;
}

std::optional<double> number_of(const files::SetsOfFile& file, const char* option) {
    const auto found = file.options.find(option);
    if (found == file.options.end()) return std::nullopt;
    std::string_view text = found->second;
    double number = 0;
    if (files::take_number(text, number) != std::errc{} || !text.empty()) return std::nullopt;
    return number;
}

}  // namespace

void ask_for_files(const CommandLine& line, const DomainOptions& options, bool distances_only,
                   const files::SetsOfFile& file, const std::string& name) {
    // The file of a set of disks holds its least radius, but the radius of an ellipse depends on
    // the direction.
    const bool has_ellipses = file.options.contains("ellipses") || file.options.contains("along");
    if (distances_only && !has_ellipses) return;
    const auto ask_for = [&](const std::string& key, std::string_view option) {
        const auto found = file.options.find(key);
        if (found == file.options.end() || line.has(option)) return;
        ask(name, std::string(option), found->second, has_ellipses ? "" : ", or --distances-only");
    };
    const std::vector<const recipes::Option*> rows = recipes::options_of(line.command);
    for (const recipes::Option* row : rows)
        if (row->names_a_file() && !row->is_argument() && row->name != "keep")
            ask_for(row->key(), row->name);
    ask_for("image", "field");  // of stipple
    if (number_of(file, "neighbours").value_or(0) > 0) ask_for("keep", "keep");
    if (options.field.path.empty()) return;
    Picture any;
    const Targets readings = targets_of(any);  // of the options that say how a picture is read
    const Json own = json_of_importance(options.field.importance);
    for (const recipes::Option* row : rows) {
        const auto found = file.options.find(row->key());
        if (!readings.contains(row->name) || found == file.options.end() || line.has(row->name))
            continue;
        if (!own.contains(row->key()) || value_text(own.at(row->key())) != found->second)
            ask(name, std::string(row->name), found->second, "");
    }
}

std::shared_ptr<const Field> use_values(const CommandLine& line, const files::SetsOfFile& file,
                                        Request& request, DomainOptions& options) {
    std::shared_ptr<const Field> field;
    const auto stretch = file.options.find("stretch");
    if (request.field == nullptr && stretch != file.options.end()) {
        EllipseOptions same;
        same.same = stretch->second;
        field = std::make_shared<const Field>(read_ellipses(same));
        request.field = field.get();
        if (!request.scale) request.scale = 1;
    }
    if (!line.has("scale") && request.field != nullptr) {
        const std::optional<double> scale = file.scale ? file.scale : number_of(file, "scale");
        if (scale) request.scale = scale;
    }
    Classes& classes = request.classes;
    if (classes.names.empty() && !file.distances.empty())
        classes = {.names = file.classes.names,
                   .distances = file.distances,
                   .weights = file.weights,
                   .counts = file.counts};
    if (!line.has("border") && !line.has("inside-by-radius")) {
        request.border = number_of(file, "border").value_or(0);
        if (classes.names == file.classes.names) classes.borders = file.borders;
        options.inside_by_radius = file.options.contains("inside_by_radius");
    }
    if (!options.edge) options.edge = number_of(file, "edge");
    return field;
}

std::size_t kept_in(const files::SetsOfFile& file) {
    const double kept = number_of(file, "kept").value_or(0);
    const auto most = static_cast<double>(file.sets.front().size());
    return static_cast<std::size_t>(std::clamp(std::floor(kept), 0.0, most));
}

}  // namespace lacuna::cli
