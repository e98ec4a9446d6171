// Takes what a call of lacuna.h is given into a request.
#include "c/given.h"

#include <cstdint>

#include "base/number_text.h"
#include "checks/classes.h"

namespace lacuna::c {
namespace {

void refuse_size_alone(const char* option, const void* first, std::size_t columns,
                       std::size_t rows) {
    if (first == nullptr && (columns != 0 || rows != 0))
        throw BadRequest(
            option, "NULL",
            "must be " + std::to_string(columns) + "x" + std::to_string(rows) + " numbers");
}

template <typename Raster, typename Value>
void take_raster(std::optional<Raster>& raster, const char* option, const Value* first,
                 std::size_t columns, std::size_t rows) {
    constexpr std::size_t kMostSide = std::size_t{1} << 20;
    if (columns == 0 || rows == 0 || columns > kMostSide || rows > kMostSide)
        throw BadRequest(option, std::to_string(columns) + "x" + std::to_string(rows),
                         "must have 1 to 1048576 columns and rows");
    raster.emplace(Raster{static_cast<std::uint32_t>(columns),
                          static_cast<std::uint32_t>(rows),
                          {first, first + columns * rows}});
}

Role role_of(const lacuna_outline& outline) {
    const std::string name = outline.role == nullptr ? "" : outline.role;
    if (const std::optional<Role> role = role_called(name)) return *role;
    throw BadRequest("outlines", shown(name), "the role must be inside, outside, avoid or near");
}

std::vector<Outline> outlines_of(const lacuna_given* given) {
    if (given->outlines == nullptr && given->outline_count != 0)
        throw BadRequest("outlines", "NULL",
                         "must be " + std::to_string(given->outline_count) + " outlines");
    std::vector<Outline> outlines;
    for (std::size_t i = 0; i < given->outline_count; ++i) {
        const lacuna_outline& one = given->outlines[i];
        Outline& outline = outlines.emplace_back();
        outline.role = role_of(one);
        if (has_distance(outline.role)) outline.distance = one.distance;
        if (one.of_class != nullptr) outline.of_class = one.of_class;
        const std::string name(name_of(outline.role));
        if (one.ring_sizes == nullptr && one.rings != 0)
            throw BadRequest(name, "NULL",
                             "must be the sizes of " + std::to_string(one.rings) + " rings");
        const double* xy = one.xy;
        for (std::size_t ring = 0; ring < one.rings; ++ring) {
            outline.polygons.rings.push_back(points_of(name.c_str(), xy, one.ring_sizes[ring]));
            if (xy != nullptr) xy += 2 * one.ring_sizes[ring];
        }
    }
    return outlines;
}

}  // namespace

std::vector<Point> points_of(const char* name, const double* xy, std::size_t count) {
    if (xy == nullptr && count != 0)
        throw BadRequest(name, "NULL", "must be " + std::to_string(count) + " points");
    std::vector<Point> points;
    points.reserve(count);
    for (std::size_t i = 0; i < count; ++i) points.push_back({xy[2 * i], xy[2 * i + 1]});
    return points;
}

std::vector<std::string_view> names_of(const lacuna_given* given, std::string_view field) {
    std::vector<std::string_view> names;
    if (given != nullptr && given->importance != nullptr) names.push_back(field);
    if (given != nullptr && given->kept_count != 0) names.emplace_back("keep");
    if (given != nullptr && given->allowed != nullptr) names.emplace_back("mask");
    for (std::size_t i = 0; given != nullptr && i < given->outline_count; ++i)
        if (given->outlines != nullptr) names.push_back(name_of(role_of(given->outlines[i])));
    return names;
}

Given::Given(const lacuna_given* given, Request& request, const options::CommandLine& line) {
    if (given == nullptr) return;
    kept_ = points_of("keep", given->kept, given->kept_count);
    request.keep = kept_;
    if ((given->kept_classes != nullptr || given->classes != nullptr) && !line.has("class"))
        throw BadRequest("classes", "given", "are for options with --class");
    if (given->kept_classes != nullptr)
        request.keep_classes = {given->kept_classes, given->kept_count};
    refuse_size_alone("field", given->importance, given->columns, given->rows);
    refuse_size_alone("mask", given->allowed, given->mask_columns, given->mask_rows);
    if (given->allowed != nullptr)
        take_raster(mask_, "mask", given->allowed, given->mask_columns, given->mask_rows);
    if (given->importance != nullptr)
        take_raster(field_, "field", given->importance, given->columns, given->rows);
    if (mask_) request.places.mask = &*mask_;
    if (field_) request.field = &*field_;
    request.places.outlines = outlines_of(given);
    if (line.has("domain")) return;
    const Boundary boundary = request.domain.boundary;
    request.domain = domain_around(request.places, request.field);
    request.domain.boundary = boundary;
}

void ClassesAndBorders::add_to(options::Targets& targets) {
    targets["class"] = &classes_.given;
    targets["between"] = &classes_.between;
    targets["priority"] = &classes_.by_priority;
    targets["border"] = &borders_;  // in place of the request's own, which is not of one class
    targets["inside-by-radius"] = &inside_by_radius_;
}

void ClassesAndBorders::take_to(Request& request) const {
    if (classes_.has_file())
        throw BadRequest("between", shown(classes_.between),
                         "must be sum or union, as lacuna.h reads no files");
    request.classes = options::read_classes(classes_, nullptr);
    take_size_of_classes(request);
    options::take_borders(borders_, request);
    request.places.border_by_radius = inside_by_radius_;
}

}  // namespace lacuna::c
