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
#include "portable/class_copies.h"

namespace lacuna::options {
namespace {

// Without a number of its own a kind whose radii are a range has so many sizes.
constexpr std::uint64_t kSizesOfRange = 8;

struct ClassText {
    std::string name;
    std::vector<double> radii;  // of its sizes; empty: none is given
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

// R, or LEAST..MOST or LEAST..MOST/SIZES: as many radii, evenly from the least to the greatest.
std::vector<double> read_radii(const std::string& text, const std::string& part) {
    const std::size_t dots = part.find("..");
    const std::size_t slash = std::min(part.find('/'), part.size());
    double least = 0, most = 0;
    std::uint64_t sizes = 1;
    read_part("class", text, part.substr(0, std::min(dots, part.size())), "its radius", least);
    if (dots != std::string::npos) {
        sizes = kSizesOfRange;
        read_part("class", text, part.substr(dots + 2, slash - dots - 2), "its radius", most);
        if (slash < part.size())
            read_part("class", text, part.substr(slash + 1), "its number of sizes", sizes);
    } else {
        most = least;
    }
    if (!(least > 0 && std::isfinite(most)))
        throw BadRequest("class", shown(text), "its radius must be a finite number over 0");
    if (dots != std::string::npos && (!(most > least) || sizes < 2 || sizes > MOST_CLASSES))
        throw BadRequest("class", shown(text),
                         "sizes must be LEAST..MOST or LEAST..MOST/SIZES, with 2 to " +
                             std::to_string(MOST_CLASSES) + " SIZES, such as 1.5..3/5");
    std::vector<double> radii;
    for (std::uint64_t i = 0; i < sizes; ++i)
        radii.push_back(i + 1 == sizes ? most
                                       : least + (most - least) * static_cast<double>(i) /
                                                     static_cast<double>(sizes - 1));
    return radii;
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
    if (parts.size() > 1 && !parts[1].empty()) read_text.radii = read_radii(text, parts[1]);
    const bool has_weight = parts.size() == 3 || (parts.size() == 4 && !parts[2].empty());
    if (has_weight) read_part("class", text, parts[2], "its weight", read_text.weight);
    if (parts.size() == 4)
        read_part("class", text, parts[3], "its number of points", read_text.count);
    return read_text;
}

// Adds a class for each size. These share the kind's weight and its number of points: as many
// points in each size, but that sizes have none of a number that is less than the sizes.
void add_sizes(const ClassText& kind, Classes& classes) {
    const std::uint64_t sizes = std::max<std::uint64_t>(1, kind.radii.size());
    const auto up_to = [&](std::uint64_t size) {
        return *kind.count / sizes * size + *kind.count % sizes * size / sizes;
    };
    for (std::uint64_t i = 0; i < sizes; ++i) {
        std::optional<std::uint64_t> count = kind.count;
        if (count) count = up_to(i + 1) - up_to(i);
        const bool has_none = sizes > 1 && count == 0;
        classes.names.push_back(kind.name);
        classes.weights.push_back(has_none              ? 0
                                  : classes.by_priority ? kind.weight
                                                        : kind.weight / static_cast<double>(sizes));
        classes.counts.push_back(has_none ? std::nullopt : count);
    }
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
        if (options.has_file() && !one.radii.empty())
            throw BadRequest("class", shown(text),
                             "must have no radius with distances from a file: give NAME or "
                             "NAME::WEIGHT");
        if (!options.has_file() && one.radii.empty())
            throw BadRequest("class", shown(text), "needs a radius: give NAME:RADIUS");
        if (options.between == "union" && one.radii.size() > 1)
            throw BadRequest("class", shown(text),
                             "sizes keep the sum of two radii: not --between "
                             "union");
        add_sizes(one, classes);
        radii.insert(radii.end(), one.radii.begin(), one.radii.end());
    }
    classes.distances = options.has_file()           ? read_matrix(options.between, classes.names)
                        : options.between == "union" ? distances_by_union(radii)
                                                     : distances_by_sum(radii);
    check_distances(classes);
    return classes;
}

std::string among_names(const std::vector<std::string>& names) {
    if (names.empty()) return "";
    std::vector<std::string_view> kinds(names.begin(), names.end());
    kinds.erase(std::unique(kinds.begin(), kinds.end()), kinds.end());  // sizes share a name
    return " (" + listed(kinds) + ")";
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
    for (std::size_t i = 0; i < count; ++i)
        request.places.borders.push_back(
            own[kind_of(classes, i).first].value_or(request.places.border));
}

}  // namespace lacuna::options
