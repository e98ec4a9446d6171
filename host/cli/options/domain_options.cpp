// The options of a domain, and the files that they name.
#include "cli/options/domain_options.h"

#include <fmt/format.h>
#include <lacuna/domains.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/number_text.h"
#include "checks/classes.h"
#include "checks/domain.h"
#include "cli/reports/report.h"
#include "files/parse.h"
#include "files/point_files.h"
#include "files/read_points.h"
#include "files/read_whole.h"
#include "pictures/importance.h"
#include "places/part.h"
#include "plan/checked_request.h"
#include "plan/kept.h"

namespace lacuna::cli {
namespace {

// The names of classes that files may be given for.
const std::vector<std::string>& names_of_classes(const DomainOptions& options,
                                                 const Request& request) {
    return options.known_classes.empty() ? request.classes.names : options.known_classes;
}

// Returns the first mask that is given, which may decide the domain; null if there is none.
const Mask* read_masks(const DomainOptions& options, Request& request, DomainFiles& files) {
    const Mask* first = nullptr;
    const std::vector<std::string>& names = names_of_classes(options, request);
    for (const std::string& text : options.mask) {
        const auto& [own, path] = class_and_path(text, names);
        check_class_of_file("mask", text, path, names);
        const auto [read, is_new] = files.pictures.try_emplace(own);
        if (!is_new)
            throw BadRequest(
                "mask", shown(text),
                own.empty() ? "a second mask for all points" : "a second mask of class " + own);
        const PlacedPicture picture = placed_picture(path);
        Mask& mask = read->second = read_mask(picture.path);
        mask.extent = extent_of("mask", picture, {mask.columns, mask.rows});
        if (first == nullptr) first = &read->second;
        if (own.empty()) request.places.mask = &read->second;
    }
    take_masks(names, files, request);
    return first;
}

void read_all_outlines(const DomainOptions& options, Request& request) {
    const std::vector<std::string>& names = names_of_classes(options, request);
    for (const auto& [role, texts] : options.outlines)
        for (const std::string& text : texts) {
            const auto& [own, path] = class_and_path(text, names);
            if (!has_distance(role))
                check_class_of_file(std::string(name_of(role)), text, path, names);
            for (Outline& one : read_outlines(role, path)) {
                one.of_class = own;
                request.places.outlines.push_back(std::move(one));
            }
        }
}

void read_picture_of_field(const DomainOptions& options, DomainFiles& files) {
    if (options.field.path.empty()) return;
    const PlacedPicture placed = placed_picture(options.field.path);
    Picture picture = options.field;
    picture.path = placed.path;
    files.field = read_field(picture);
    files.extent = extent_of("field", placed, {files.field->columns, files.field->rows});
}

}  // namespace

void take_shape(const Domain& shape, Request& request) {
    const Boundary boundary = request.domain.boundary;
    request.domain = shape;
    request.domain.boundary = boundary;
}

Targets targets_of(DomainOptions& options) {
    Targets targets{{"field", &options.field.path},
                    {"ellipses", &options.ellipses.path},
                    {"stretch", &options.ellipses.same},
                    {"class", &options.classes.given},
                    {"between", &options.classes.between},
                    {"priority", &options.classes.by_priority},
                    {"mask", &options.mask},
                    {"edge", &options.edge},
                    {"border", &options.borders},
                    {"inside-by-radius", &options.inside_by_radius},
                    {"keep", &options.keep}};
    for (const Role role : kRoles) targets[name_of(role)] = &options.outlines[role];
    targets.merge(targets_of(options.field));
    return targets;
}

void read_given_files(const CommandLine& line, const DomainOptions& options, Request& request,
                      DomainFiles& files) {
    request.classes = options::read_classes(options.classes, read_matrix);
    const std::vector<std::string>& classes = names_of_classes(options, request);
    refuse_class_of_file("field", options.field.path, classes, "a class has no field of its own");
    refuse_class_of_file("keep", options.keep, classes, "its column class has each point's class");
    read_picture_of_field(options, files);
    if (options.ellipses.are_given()) {
        files.field = read_ellipses(options.ellipses);
        if (!request.scale && !request.count) request.scale = 1;
    }
    if (files.field) request.field = &*files.field;
    read_all_outlines(options, request);
    const Mask* const mask = read_masks(options, request, files);
    const bool is_same_everywhere = !options.ellipses.same.empty();
    if (!line.has("domain") && !request.on_pixels) {
        Places around = request.places;
        if (mask != nullptr) around.mask = mask;
        take_shape(files.extent
                       ? *files.extent
                       : domain_around(around, is_same_everywhere ? nullptr : request.field),
                   request);
    }
    take_size_of_classes(request);
    if (options.keep.empty()) return;
    if (request.classes.names.empty()) {
        files.keep = files::read_points(options.keep).points;
    } else {
        files::PointsOfFile file = files::read_points(options.keep);
        const std::string name = files::name_of(options.keep);
        files.keep_classes = classes_in(file, request.classes, name);
        files.keep = std::move(file.points);
    }
    request.keep = files.keep;
    request.keep_classes = files.keep_classes;
}

namespace {

// What a page that is stretched unevenly over the domain becomes; empty if there is none.
std::string hint_of_pages(const Request& request) {
    constexpr double kMost = 1.01;  // pages are rounded
    for (const Outline& outline : request.places.outlines) {
        if (!outline.polygons.page) continue;
        const Domain& page = *outline.polygons.page;
        const double across = request.domain.width / page.width;
        const double up = request.domain.height / page.height;
        if (std::max(across / up, up / across) > kMost)
            return fmt::format(
                "lacuna: an SVG page of {:.6g} x {:.6g} is stretched over the domain: {:.3g} times "
                "across and {:.3g} times upwards\n",
                page.width, page.height, across, up);
    }
    return "";
}

}  // namespace

void read_domain_files(const CommandLine& line, const DomainOptions& options, Request& request,
                       DomainFiles& files) {
    read_given_files(line, options, request, files);
    if (files.extent) files.field = field_in(request.domain, files);
    request.places.edge = options.edge;
    request.places.border_by_radius = options.inside_by_radius;
    options::take_borders(options.borders, request);
    files.chunk = options::chunk_of(options.chunk, request);
    if (files.chunk && line.has("domain"))
        throw BadRequest("chunk", options.chunk.at + " with --domain", "is a domain by itself");
    if (files.chunk) request = files.chunk->request;
    files.hint = hint_of_pages(request);
    Resolved resolved = resolve(request);
    request = std::move(resolved.request);
    files.masks = resolved.masks;
    files.edge = resolved.edge;
}

Field field_in(const Domain& domain, const DomainFiles& files) {
    Field field = *files.field;
    const Raster picture{field.columns, field.rows};
    const places::Part part = places::part_of(picture, *files.extent, domain, "field");
    field.columns = part.columns;
    field.rows = part.rows;
    field.importance = places::cut(field.importance, picture, part);
    if (!field.stretches.empty()) field.stretches = places::cut(field.stretches, picture, part);
    return field;
}

void take_masks(const std::vector<std::string>& names, const DomainFiles& files, Request& request) {
    std::vector<const Mask*>& masks = request.places.masks;
    masks.clear();
    for (const auto& [own, mask] : files.pictures) {
        if (own.empty()) continue;
        if (std::find(names.begin(), names.end(), own) == names.end())
            throw BadRequest("mask", own, "is no class of this set");
        masks.resize(names.size());
        for (std::size_t i = 0; i < names.size(); ++i)
            if (names[i] == own) masks[i] = &mask;
    }
}

Request as_made(Request request, const Result& result) {
    const double factor = distance_factor(request, result);
    for (double& distance : request.classes.distances) distance *= factor;
    if (request.field == nullptr) request.radius = result.radius;
    return request;
}

namespace {

// Which classes may lie nowhere.
std::string words_of_no_place(const Request& request) {
    const std::vector<std::string>& names = request.classes.names;
    std::vector<std::string> without;
    bool are_drawn = false;
    for (std::size_t i = 0; i < std::max<std::size_t>(names.size(), 1); ++i) {
        const Mask* const mask = mask_of(request, i);
        if (mask == nullptr || allows_some(*mask)) continue;
        without.push_back(names.empty() ? "" : names[i]);
        are_drawn |= mask->drawn != nullptr;
    }
    if (without.empty()) return "";
    const std::string who =
        without.size() < names.size() ? fmt::format(" for {}", fmt::join(without, ", ")) : "";
    return are_drawn
               ? fmt::format(" (the domain, {}, has no open place{} wider than twice the --edge)",
                             extent_of(request.domain, ')'), who)
               : fmt::format(" (the mask{} is black all over)", who);
}

}  // namespace

std::string words_of_places(const Request& request) {
    const SortedKept kept = sorted_kept(request);
    // Without a radius all points outside count, although those far away will have no effect.
    const char* const most = kept.has_radius ? "" : "up to ";
    return words_of_no_place(request) +
           (kept.members == 0 ? "" : fmt::format(", {} of them kept", kept.members)) +
           (kept.neighbours() == 0
                ? ""
                : fmt::format(", beside {}{} kept outside", most, kept.neighbours()));
}

Json json_of(const DomainOptions& options, const Request& request, const DomainFiles& files) {
    Json json = Json::object();
    json.update(json_of(options.ellipses));
    if (!options.field.path.empty()) {
        json["field"] = options.field.path;
        json.update(json_of_importance(options.field.importance));
    }
    // One name is a text, and several are a list.
    const auto add_paths = [&](std::string_view name, const std::vector<std::string>& paths) {
        if (!paths.empty())
            json[std::string(name)] = paths.size() == 1 ? Json(paths.front()) : Json(paths);
    };
    add_paths("mask", options.mask);
    for (const auto& [role, texts] : options.outlines) add_paths(name_of(role), texts);
    if (files.edge != 0) json["edge"] = files.edge;
    json.update(json_of(request.classes));
    if (!request.places.borders.empty()) json["borders"] = request.places.borders;
    if (request.places.border != 0) json["border"] = request.places.border;
    if (options.inside_by_radius) json["inside_by_radius"] = true;
    if (files.chunk) json.update({{"chunk", options.chunk.at}, {"chunk_size", options.chunk.size}});
    if (options.keep.empty() && !files.chunk) return json;
    const SortedKept kept = sorted_kept(request);
    const char* const of_chunk = "the points of the chunks beside it";
    json.update({{"keep", files.chunk ? of_chunk : options.keep}, {"kept", kept.members}});
    if (kept.has_radius && kept.neighbours() > 0) json["neighbours"] = kept.neighbours();
    return json;
}

std::vector<double> dots_of(const Request& request, std::span<const Point> points,
                            stippling::Spread spread) {
    if (request.field == nullptr) return {};
    return stippling::dot_diameters(points, *request.field, request.domain, spread);
}

}  // namespace lacuna::cli
