// Draws the polygons and obstacles of a command's options onto masks, for all points or for each
// class.
#include <lacuna/domains.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "cli/options/domain_options.h"
#include "plan/checked_request.h"
#include "plan/radius_field.h"
#include "plan/sheets.h"
#include "plan/sizes.h"
#include "recipes/classes.h"
#include "sampling/on_pixels.h"

namespace lacuna::cli {
namespace {

// How far the outline of polygons may be off without --edge, in least radii. 1/16 keeps the mask
// small and the error well under the distance of points.
constexpr double kEdge = 1.0 / 16;

double greatest_of(const DomainFiles& files) {
    if (!files.field) return 1;
    return *std::max_element(files.field->importance.begin(), files.field->importance.end());
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
double least_radius(const Request& request, std::span<const PolygonSet> sets,
                    const DomainFiles& files) {
    if (request.on_pixels) return least_pixel_step(*request.on_pixels, request.domain);
    const double greatest = greatest_of(files);
    if (request.radius) return *request.radius;
    if (request.scale) return *request.scale / std::sqrt(greatest);
    if (!request.count || *request.count == 0) return request.domain.longer_side() / 1000;
    const Mask mask = coarse_places(request, sets);
    Request trial = request;
    if (allows_some(mask)) trial.mask = &mask;  // otherwise other classes decide, or nothing does
    return radius_field_scale_for_count(trial, static_cast<double>(*request.count)) /
           std::sqrt(greatest);
}

// A refusal of an edge that was not given says what it is.
BadRequest without_edge(const BadRequest& error, const Request& request) {
    return {"edge",
            error.value() + (request.on_pixels ? " (by default a sixteenth of a pixel)"
                                               : " (by default a sixteenth of the least radius)"),
            error.reason()};
}

// Refuses a radius that is too small before its sixteenth is refused as an edge.
void check_radius_of_edge(double edge, const Request& request) {
    if (edge >= kEdge * kSmallestRadius * request.domain.longer_side()) return;
    check_classes(request);
    const std::optional<double>& size = request.field != nullptr ? request.scale : request.radius;
    if (size) check_radius_field_size(request, *size, nobody_asks);
}

// Adds the images of the rings around a torus.
void repeat(const Request& request, std::vector<PolygonRing>& rings) {
    const std::vector<PolygonRing> own = rings;
    for (const int across : {-1, 0, 1})
        for (const int up : {-1, 0, 1})
            for (const PolygonRing& ring : own) {
                if (across == 0 && up == 0) continue;
                PolygonRing& image = rings.emplace_back(ring);
                for (Point& point : image)
                    point = {point.x + across * request.domain.width,
                             point.y + up * request.domain.height};
            }
}

}  // namespace

std::vector<std::vector<PolygonRing>> rings_of(const Request& request, const DomainFiles& files) {
    std::vector<std::vector<PolygonRing>> rings;
    for (const Polygons& polygons : files.polygons) {
        rings.push_back(fitted(polygons, request.domain));
        const bool is_obstacle = files.kinds[rings.size() - 1].distance > 0;
        if (is_obstacle && request.domain.wraps()) repeat(request, rings.back());
    }
    return rings;
}

std::vector<Clearances> clearances_of(const DomainOptions& options, const Request& request,
                                      const DomainFiles& files) {
    const std::vector<std::string>& names = request.classes.names;
    bool are_alike = request.classes.borders.empty();
    for (std::size_t kind = 0; kind < files.kinds.size(); ++kind) {
        const std::string& own = files.own[kind];
        are_alike &= own.empty();
        if (!own.empty() && std::find(names.begin(), names.end(), own) == names.end())
            throw BadRequest(files.kinds[kind].option, own, "is no class of this set");
    }
    const auto is_one_for = [&](std::size_t kind, std::size_t of_class) {
        return !files.own[kind].empty() && files.own[kind] == names[of_class];
    };
    std::vector<Clearances> all(are_alike ? 1 : names.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        bool has_inside = false;  // of its own
        for (std::size_t kind = 0; kind < files.kinds.size(); ++kind)
            has_inside |= !files.kinds[kind].forbidden && is_one_for(kind, i);
        for (std::size_t kind = 0; kind < files.kinds.size(); ++kind) {
            const PolygonSet& set = files.kinds[kind];
            const bool is_for_all =
                files.own[kind].empty() && (set.forbidden || set.near || !has_inside);
            if (!is_for_all && !is_one_for(kind, i)) continue;
            // Without a distance it is no obstacle.
            const bool has_border = set.distance == 0 || (options.inside_by_radius && !set.near);
            all[i].emplace_back(kind, set.distance + (has_border ? border_of(request, i) : 0));
        }
    }
    return all;
}

std::vector<PolygonSet> sets_of(const Clearances& clearances, std::span<const PolygonSet> kinds,
                                std::span<const std::vector<PolygonRing>> rings) {
    std::vector<PolygonSet> sets;
    for (const auto& [kind, distance] : clearances) {
        PolygonSet& set = sets.emplace_back(kinds[kind]);
        set.rings = rings[kind];
        set.distance = distance;
    }
    return sets;
}

double edge_of(const DomainOptions& options, const Request& request,
               std::span<const PolygonSet> sets, const DomainFiles& files) {
    if (options.edge) return *options.edge;
    const double edge = kEdge * least_radius(request, sets, files);
    // If the edge is invalid, so is the radius, and the check of the request will refuse that.
    if (edge > 0 && std::isfinite(edge)) return edge;
    return request.domain.longer_side() / 1000;
}

void read_domain_files(const CommandLine& line, const DomainOptions& options, Request& request,
                       DomainFiles& files) {
    read_given_files(line, options, request, files);
    recipes::take_borders(options.borders, options.inside_by_radius, request);
    take_masks(files, request);
    if (files.polygons.empty()) return;
    const std::vector<std::vector<PolygonRing>> rings = rings_of(request, files);
    const std::vector<Clearances> all = clearances_of(options, request, files);
    const auto draw = [&](const Clearances& clearances) {
        try {
            return draw_places(sets_of(clearances, files.kinds, rings), request.domain, files.edge,
                               request.place.memory_limit_bytes);
        } catch (const BadRequest& error) {
            if (options.edge || error.option() != "edge") throw;
            throw without_edge(error, request);
        }
    };
    const Clearances& some = *std::max_element(
        all.begin(), all.end(),
        [](const Clearances& a, const Clearances& b) { return a.size() < b.size(); });
    files.edge = edge_of(options, request, sets_of(some, files.kinds, rings), files);
    if (!options.edge) check_radius_of_edge(files.edge, request);
    if (all.size() == 1) {
        files.mask = draw(all.front());
        request.mask = &*files.mask;
        return;
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Clearances& own = all[i];
        if (own.empty()) {
            request.classes.masks.push_back(nullptr);
            continue;
        }
        const auto [drawn, is_new] = files.masks_of_classes.try_emplace(own);
        if (is_new) drawn->second = draw(own);
        request.classes.masks.push_back(&drawn->second);
    }
}

}  // namespace lacuna::cli
