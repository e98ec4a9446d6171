// Reads classes, their distances and their borders.
#include "options/classes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/number_text.h"
#include "checks/classes.h"
#include "options/read.h"
#include "options/words.h"

namespace lacuna::options {
namespace {

struct ClassText {
    std::string name;
    std::optional<double> radius;
    double weight = 1;
    std::optional<std::uint64_t> count;
};

// Reads a number that is a part of an option's value, and names both if it is none.
template <class Number>
void read_part(const char* option, const std::string& value, const std::string& part,
               const std::string& what, Number& number) {
    try {
        read(option, part, number);
    } catch (const BadRequest& error) {
        throw BadRequest(option, shown(value), what + " " + error.reason());
    }
}

ClassText read_class(const std::string& text) {
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == ':')
            parts.emplace_back();
        else
            parts.back() += c;
    }
    ClassText read_text{parts.front(), {}, 1, {}};
    if (parts.size() > 4 || read_text.name.empty())
        throw BadRequest("class", shown(text),
                         "must be NAME:RADIUS, NAME:RADIUS:WEIGHT or NAME:RADIUS:WEIGHT:N");
    if (parts.size() > 1 && !parts[1].empty())
        read_part("class", text, parts[1], "its radius", read_text.radius);
    const bool has_weight = parts.size() == 3 || (parts.size() == 4 && !parts[2].empty());
    if (has_weight) read_part("class", text, parts[2], "its weight", read_text.weight);
    if (parts.size() == 4)
        read_part("class", text, parts[3], "its number of points", read_text.count);
    return read_text;
}

}  // namespace

Classes read_classes(const ClassOptions& options,
                     std::vector<double> (*read_matrix)(const std::string& path,
                                                        const std::vector<std::string>& names)) {
    Classes classes;
    classes.by_priority = options.by_priority;
    if (options.given.empty()) return classes;
    std::vector<double> radii;
    for (const std::string& text : options.given) {
        const ClassText one = read_class(text);
        if (options.has_file() && one.radius)
            throw BadRequest("class", shown(text),
                             "must have no radius with distances from a file: give NAME or "
                             "NAME::WEIGHT");
        if (!options.has_file() && !one.radius)
            throw BadRequest("class", shown(text), "needs a radius: give NAME:RADIUS");
        if (one.radius && !(*one.radius > 0 && std::isfinite(*one.radius)))
            throw BadRequest("class", shown(text), "its radius must be a finite number over 0");
        classes.names.push_back(one.name);
        classes.weights.push_back(one.weight);
        classes.counts.push_back(one.count);
        radii.push_back(one.radius.value_or(0));
    }
    classes.distances = options.has_file()           ? read_matrix(options.between, classes.names)
                        : options.between == "union" ? distances_by_union(radii)
                                                     : distances_by_sum(radii);
    check_distances(classes);
    return classes;
}

std::string among_names(const std::vector<std::string>& names) {
    if (names.empty()) return "";
    return " (" + listed(std::vector<std::string_view>(names.begin(), names.end())) + ")";
}

void take_borders(const std::vector<std::string>& borders, Request& request) {
    const Classes& classes = request.classes;
    const std::size_t count = classes.names.size();
    std::optional<double> of_all;
    std::vector<std::optional<double>> own(count);
    for (const std::string& text : borders) {
        const std::size_t colon = text.find(':');
        const auto found = std::find(classes.names.begin(), classes.names.end(),
                                     text.substr(0, std::min(colon, text.size())));
        if (colon != std::string::npos && found == classes.names.end())
            throw BadRequest(
                "border", shown(text),
                "must be D, or NAME:D with the name of a class" + among_names(classes.names));
        std::optional<double>& border =
            colon == std::string::npos
                ? of_all
                : own[static_cast<std::size_t>(found - classes.names.begin())];
        if (border) throw BadRequest("border", shown(text), "is given twice");
        if (colon == std::string::npos)
            read("border", text, border);
        else
            read_part("border", text, text.substr(colon + 1), "D", border);
    }
    if (of_all) request.places.border = *of_all;
    const auto has_own = [](const std::optional<double>& one) { return one.has_value(); };
    if (std::none_of(own.begin(), own.end(), has_own)) return;
    request.places.borders.clear();
    for (const std::optional<double>& one : own)
        request.places.borders.push_back(one.value_or(request.places.border));
}

}  // namespace lacuna::options
