// Draws the outlines of a request onto masks, for all points or for each class.
#include <lacuna/sample.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "checks/classes.h"
#include "checks/pixels.h"
#include "places/mask_outlines.h"
#include "places/part.h"
#include "places/sets.h"
#include "plan/checked_request.h"
#include "plan/radius_field.h"
#include "plan/sizes.h"

namespace lacuna {
namespace {

double greatest_importance(const Request& request) {
    if (request.field == nullptr) return 1;
    check_importance(*request.field);
    return *std::max_element(request.field->importance.begin(), request.field->importance.end());
}

// An edge for the estimate of an area: fine enough for the places to have some thousand pixels
// along their outlines, whatever the extent of the domain.
double coarse_edge(const Request& request, std::span<const PolygonSet> sets) {
    constexpr double kSteps = 8192;
    const double longer = request.domain.longer_side();
    double length = 0;
    for (const PolygonSet& set : sets)
        for (const PolygonRing& ring : set.rings)
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Point& to = ring[(i + 1) % ring.size()];
                length += std::hypot(to.x - ring[i].x, to.y - ring[i].y) + set.distance;
            }
    return std::clamp(length / kSteps, longer * 0x1p-23, longer / 1000);
}

// The places with a coarse outline. Where nothing is wide enough for it, with a finer one.
Mask coarse_places(const Request& request, std::span<const PolygonSet> sets) {
    constexpr double kLeast = 0x1p-22;  // of the longer side
    const double longer = request.domain.longer_side();
    double edge = coarse_edge(request, sets);
    for (;; edge /= 4) {
        Mask mask = draw_places(sets, request.domain, edge);
        if (edge < longer * kLeast || allows_some(mask)) return mask;
    }
}

// The least radius of the set. For a count it is the radius of a maximal set of this size.
double least_radius(const Request& request, std::span<const PolygonSet> sets) {
    if (request.on_pixels) return least_pixel_step(*request.on_pixels, request.domain);
    const double greatest = greatest_importance(request);
    if (request.radius) return *request.radius;
    if (request.scale) return *request.scale / std::sqrt(greatest);
    if (!request.count || *request.count == 0) return request.domain.longer_side() / 1000;
    const Mask mask = coarse_places(request, sets);
    Request trial = request;
    // If these outlines leave no room, the other classes' room decides, or the set will be empty.
    if (allows_some(mask)) trial.places.mask = &mask;
    return radius_field_scale_for_count(trial, static_cast<double>(*request.count)) /
           std::sqrt(greatest);
}

// A sixteenth of the least radius.
double usual_edge(const Request& request, std::span<const PolygonSet> sets) {
    const double radius = least_radius(request, sets);
    const double edge = places::edge_of_radius(radius);
    // If the edge is invalid, so is the radius, and the check of the request will refuse that.
    if (!(edge > 0) || !std::isfinite(edge)) return request.domain.longer_side() / 1000;
    // A radius that is too small is refused before its sixteenth is refused as an edge.
    if (edge < places::edge_of_radius(kSmallestRadius * request.domain.longer_side())) {
        check_classes(request);
        const std::optional<double>& size =
            request.field != nullptr ? request.scale : request.radius;
        if (size || (request.count && !request.on_pixels))
            check_radius_field_size(request,
                                    size.value_or(radius * std::sqrt(greatest_importance(request))),
                                    nobody_asks);
    }
    return edge;
}

// A refusal of an edge that was not given says what it is.
BadRequest without_edge(const BadRequest& error, const Request& request) {
    return {"edge",
            error.value() + (request.on_pixels ? " (by default a sixteenth of a pixel)"
                                               : " (by default a sixteenth of the least radius)"),
            error.reason()};
}

void take_border(Request& request) {
    const auto refuse = [](const char* with, const char* why) {
        throw BadRequest("inside-by-radius", with, why);
    };
    if (request.places.border != 0 || !request.places.borders.empty())
        refuse("with --border", "both say how far to stay");
    if (request.count) refuse("with --count", "the radius must be known before: give it");
    if (request.on_pixels) refuse("with --on-pixels", "its samples keep no distance");
    if (request.field != nullptr)
        refuse("with --field", "is for disks of one size, or of one for each class");
    check_classes(request);
    places::take_border_by_radius(request.radius, request.domain, request.classes, request.places);
}

// Draws the sets of all points, or those of each class.
std::vector<Mask> masks_of(const Request& request, const places::Sets& sets, double edge,
                           bool is_given) {
    std::vector<Mask> masks(sets.size());
    for (std::size_t i = 0; i < sets.size(); ++i) {
        const std::size_t first = sets.first_like(i);
        if (first < i) masks[i] = masks[first];
        if (first < i || sets[i].empty()) continue;
        try {
            masks[i] =
                draw_places(sets[i], request.domain, edge, request.run_on.memory_limit_bytes);
        } catch (const BadRequest& error) {
            if (is_given || error.option() != "edge") throw;
            throw without_edge(error, request);
        }
    }
    return masks;
}

}  // namespace

Resolved resolve(const Request& given) {
    Resolved resolved{.request = given};
    Request& request = resolved.request;
    if (request.places.border_by_radius) take_border(request);
    const Classes& classes = request.classes;
    resolved.masks = places::cut_masks(request.domain, request.places);
    places::turn_masks_into_outlines(request.domain, classes, request.places);
    const Places places = request.places;
    request.places = {.mask = places.mask,
                      .border = places.border,
                      .borders = places.borders,
                      .masks = places.masks};
    if (places.outlines.empty()) return resolved;
    if (!classes.names.empty() && !request.count) check_distances(classes);
    take_size_of_classes(request);
    const places::Sets sets(places, request.domain, classes);
    resolved.edge = places.edge ? *places.edge : usual_edge(request, sets.most());
    const auto masks = std::make_shared<const std::vector<Mask>>(
        masks_of(request, sets, resolved.edge, places.edge.has_value()));
    resolved.masks = masks;
    if (masks->size() == 1) {
        request.places.mask = &masks->front();
        return resolved;
    }
    for (const Mask& mask : *masks) request.places.masks.push_back(mask.drawn ? &mask : nullptr);
    return resolved;
}

}  // namespace lacuna
