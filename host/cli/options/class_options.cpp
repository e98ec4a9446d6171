// Classes in files: matrices of distances, the class of each point, and what reports say.
#include "cli/options/domain_options.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "base/number_text.h"
#include "checks/classes.h"
#include "domains/rings.h"
#include "files/csv_rows.h"
#include "files/parse.h"
#include "files/read_whole.h"
#include "options/classes.h"
#include "stipple/dot_size.h"

namespace lacuna::cli {
namespace {

using Json = nlohmann::ordered_json;

// The matrix with rows and columns in the order of `names`. `down` and `across` are the places of
// its own rows and columns there; empty if these have no names.
std::vector<double> in_order(const std::vector<double>& all, std::vector<std::size_t> down,
                             std::vector<std::size_t> across, std::size_t count,
                             const std::string& file) {
    if (down.empty()) down = across;
    if (across.empty()) across = down;
    if (down.empty() || all.size() != count * count) return all;
    const auto has_each = [&](std::vector<std::size_t> places) {
        std::sort(places.begin(), places.end());
        places.erase(std::unique(places.begin(), places.end()), places.end());
        return places.size() == count;
    };
    if (!has_each(down) || !has_each(across))
        files::refuse(file, "must name each class once, or none");
    std::vector<double> sorted(all.size());
    for (std::size_t i = 0; i < all.size(); ++i)
        sorted[down[i / count] * count + across[i % count]] = all[i];
    return sorted;
}

// Rows and columns may have the names of classes; without names they are in the order of `names`.
std::vector<double> matrix_of_csv(std::string bytes, const std::string& file,
                                  const std::vector<std::string>& names) {
    // Blanks separate numbers, too, where nothing else does.
    const auto are_blanks = [](char a, char b) { return a == ' ' && b == ' '; };
    if (bytes.find_first_of(",;\t") == std::string::npos) {
        bytes.erase(std::unique(bytes.begin(), bytes.end(), are_blanks), bytes.end());
        std::replace(bytes.begin(), bytes.end(), ' ', '\t');
    }
    files::CsvRows rows(bytes, file);
    const auto place_of = [&](std::string_view name) {
        const auto found = std::find(names.begin(), names.end(), name);
        if (found == names.end())
            files::refuse(rows.place(),
                          fmt::format("{} must be a number, such as 0.25, or a class{}",
                                      files::excerpt(name), options::among_names(names)));
        return static_cast<std::size_t>(found - names.begin());
    };
    std::vector<double> all;
    std::vector<std::size_t> down, across;
    while (rows.next()) {
        const bool has_name = !files::is_number(rows.field(0));
        if (has_name) down.push_back(place_of(rows.field(0)));
        for (std::size_t column = has_name ? 1 : 0; column < rows.columns(); ++column)
            all.push_back(rows.number(column));
    }
    // The column of names has another name, or none.
    for (std::size_t column = down.empty() ? 0 : 1; column < rows.names().size(); ++column)
        across.push_back(place_of(rows.names()[column]));
    return in_order(all, std::move(down), std::move(across), names.size(), file);
}

std::vector<double> matrix_of_json(const std::string& bytes, const std::string& name) {
    const nlohmann::json rows = nlohmann::json::parse(bytes, nullptr, false);
    std::vector<double> all;
    const auto is_number = [](const auto& one) { return one.is_number(); };
    if (!rows.is_array()) files::refuse(name, "must be an array of rows, such as [[2, 1], [1, 2]]");
    for (const auto& row : rows) {
        if (!row.is_array() || row.size() != rows.size() ||
            !std::all_of(row.begin(), row.end(), is_number))
            files::refuse(name, fmt::format("each row must be an array of {} numbers, as many as "
                                            "there are rows",
                                            rows.size()));
        for (const auto& number : row) all.push_back(number.template get<double>());
    }
    return all;
}

}  // namespace

std::vector<double> read_matrix(const std::string& path, const std::vector<std::string>& names) {
    std::string bytes = files::read_whole(path);
    const std::string name = files::name_of(path);
    if (path.ends_with(".json")) return matrix_of_json(bytes, name);
    return matrix_of_csv(std::move(bytes), name, names);
}

namespace {

// The class of a point of the file, among those of its kind: the one that has its radius.
std::size_t size_among(const files::PointsOfFile& file, std::size_t point, const Classes& classes,
                       const KindOfClass& kind, const std::string& name) {
    constexpr double kRounded = 1e-6;  // files of other programs have few digits
    const std::string& own = classes.names[kind.first];
    if (kind.first == kind.last) return kind.first;
    if (file.radii.empty())
        throw files::FileError(fmt::format(
            "{}: needs a column radius, because the class {} has several sizes", name, own));
    for (std::size_t i = kind.first; i <= kind.last; ++i) {
        const double radius = own_distance_of(classes, i) / 2;
        if (std::abs(radius - file.radii[point]) <= kRounded * radius) return i;
    }
    throw files::FileError(
        fmt::format("{}: point {} of the class {} has the radius {}: must be "
                    "that of one of its sizes",
                    name, point, own, shortest(file.radii[point])));
}

}  // namespace

std::pair<std::string, std::string> class_and_path(const std::string& text,
                                                   const std::vector<std::string>& names) {
    const std::size_t colon = std::min(text.find(':'), text.size());
    const std::string name = text.substr(0, colon);
    if (colon == text.size() || std::find(names.begin(), names.end(), name) == names.end())
        return {"", text};
    return {name, text.substr(colon + 1)};
}

void refuse_class_of_file(const std::string& option, const std::string& text,
                          const std::vector<std::string>& names, const std::string& why) {
    const std::string path = class_and_path(text, names).second;
    if (path != text && !std::filesystem::exists(text))
        throw BadRequest(option, shown(text), "must be FILE alone: " + why);
}

void check_class_of_file(const std::string& option, const std::string& text,
                         const std::string& path, const std::vector<std::string>& names) {
    if (names.empty()) return;
    if (path.empty()) throw BadRequest(option, shown(text), "must be NAME:FILE, with a file");
    const std::string name = path.substr(0, path.find(':'));
    if (path != text || name == path || name.find('/') != std::string::npos ||
        std::filesystem::exists(domains::file_and_layer(path).file))
        return;
    throw BadRequest(option, shown(text),
                     "there is no such file, and " + shown(name) + " is not a class" +
                         options::among_names(names));
}

std::vector<std::uint8_t> classes_in(const files::PointsOfFile& file, const Classes& classes,
                                     const std::string& name) {
    if (file.classes.names.empty() && !file.points.empty())
        throw files::FileError(name +
                               ": its points have no class: with --class a .csv needs a column "
                               "class with names, as lacuna writes it");
    // Numbers are places of the options, in their order.
    const bool has_places = file.classes.are_numbers || file.classes.names == classes.names;
    std::vector<KindOfClass> kinds;
    for (const std::string& one : file.classes.names) {
        const auto found = std::find(classes.names.begin(), classes.names.end(), one);
        const std::size_t place =
            has_places ? kinds.size() : static_cast<std::size_t>(found - classes.names.begin());
        if (place >= classes.names.size())
            throw files::FileError(fmt::format(
                "{}: has points of the class {}, which no --class names", name, shown(one)));
        kinds.push_back(has_places ? KindOfClass{place, place} : kind_of(classes, place));
    }
    std::vector<std::uint8_t> of_points;
    of_points.reserve(file.classes.of_point.size());
    for (const std::uint8_t one : file.classes.of_point)
        of_points.push_back(static_cast<std::uint8_t>(
            size_among(file, of_points.size(), classes, kinds[one], name)));
    return of_points;
}

std::vector<files::Layer> layers_of(const Classes& classes, const Result& result) {
    if (classes.names.empty()) return {};
    return files::layers_of_classes(classes.names, result.classes);
}

std::vector<double> class_diameters(const Request& request, const Result& result) {
    const double scale = distance_factor(request, result);
    std::vector<double> diameters;
    diameters.reserve(result.points.size());
    for (std::size_t i = 0; i < result.points.size(); ++i) {
        const double own = own_distance_of(request.classes, result.classes[i]) * scale;
        const double importance =
            request.field == nullptr
                ? 1
                : stippling::importance_at(result.points[i], *request.field, request.domain);
        diameters.push_back(2. / 3 * own / std::sqrt(importance));
    }
    return diameters;
}

Json json_of(const Classes& classes) {
    Json json = Json::object();
    if (classes.names.empty()) return json;
    Json rows = Json::array();
    const std::size_t count = classes.names.size();
    for (std::size_t i = 0; i < count; ++i)
        rows.push_back(std::vector<double>(
            classes.distances.begin() + static_cast<std::ptrdiff_t>(i * count),
            classes.distances.begin() + static_cast<std::ptrdiff_t>((i + 1) * count)));
    json["class_names"] = classes.names;
    json["distances"] = rows;
    json["weights"] = classes.weights;
    if (classes.by_priority) json["priority"] = true;
    if (has_counts(classes))
        for (const auto& own : classes.counts)
            json["counts"].push_back(own ? Json(*own) : Json(nullptr));
    return json;
}

}  // namespace lacuna::cli
