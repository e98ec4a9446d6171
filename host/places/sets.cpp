// Resolves outlines for a domain and its classes.
#include "places/sets.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/number_text.h"
#include "base/polling.h"
#include "checks/classes.h"
#include "checks/numbers.h"
#include "places/mask_outlines.h"
#include "places/part.h"

namespace lacuna {

std::string_view name_of(Role role) {
    switch (role) {
        case Role::inside:
            return "inside";
        case Role::outside:
            return "outside";
        case Role::avoid:
            return "avoid";
        case Role::near:
            return "near";
    }
    return "";
}

std::vector<PolygonRing> fitted(Polygons polygons, const Domain& domain) {
    if (!polygons.page) return std::move(polygons.rings);
    const double along = domain.width / polygons.page->width;
    const double up = domain.height / polygons.page->height;
    if (along == 1 && up == 1 && !domain.has_corner()) return std::move(polygons.rings);
    for (PolygonRing& ring : polygons.rings)
        for_each_polled(ring.size(), ask, [&](std::size_t i) {
            ring[i] = domain.at({ring[i].x * along, ring[i].y * up});
        });
    return std::move(polygons.rings);
}

std::optional<Role> role_called(std::string_view name) {
    for (const Role role : kRoles)
        if (name == name_of(role)) return role;
    return std::nullopt;
}

namespace places {
namespace {

// The length of a unit of the page.
double scale_of_page(const Polygons& polygons, Role role, const Domain& domain) {
    if (!polygons.page) return 1;
    const double along = domain.width / polygons.page->width;
    const double up = domain.height / polygons.page->height;
    constexpr double kRounding = 1e-9;
    if (std::abs(along - up) > kRounding * std::max(along, up))
        throw BadRequest(std::string(name_of(role)), "with strokes",
                         "the domain must have the shape of the page, or strokes are not equally "
                         "wide everywhere");
    return along;
}

// Adds the images of the last rings around a torus. Each image is a set of its own, because where
// two of them overlap a place is inside of both.
void repeat(const Domain& domain, std::vector<std::vector<PolygonRing>>& sets) {
    const std::vector<PolygonRing> own = sets.back();
    for (const int across : {-1, 0, 1})
        for (const int up : {-1, 0, 1}) {
            if (across == 0 && up == 0) continue;
            for (PolygonRing& ring : sets.emplace_back(own))
                for (Point& point : ring)
                    point = {point.x + across * domain.width, point.y + up * domain.height};
        }
}

}  // namespace

Sets::Sets(const Places& places, const Domain& domain, const Classes& classes) {
    const std::vector<std::string>& names = classes.names;
    const std::vector<Outline>& outlines = places.outlines;
    bool are_alike = places.borders.empty();
    std::vector<double> scales;         // of distances
    std::vector<std::size_t> first{0};  // of the rings of an outline; then their end
    for (const auto& [polygons, role, distance, of_class, is_on_page] : outlines) {
        if (name_of(role).empty())
            throw BadRequest("inside", std::to_string(static_cast<long long>(role)),
                             "must be Role::inside, outside, avoid or near");
        are_alike &= of_class.empty();
        if (!of_class.empty() && std::find(names.begin(), names.end(), of_class) == names.end())
            throw BadRequest(std::string(name_of(role)), of_class, "is no class of this set");
        scales.push_back(is_on_page ? scale_of_page(polygons, role, domain) : 1);
        rings_.push_back(fitted(polygons, domain));
        if (has_distance(role) && domain.wraps()) repeat(domain, rings_);
        first.push_back(rings_.size());
    }
    kinds_.resize(are_alike ? 1 : names.size());
    for (std::size_t kind = 0; kind < kinds_.size(); ++kind) {
        const auto is_own = [&](const Outline& one) {
            return !one.of_class.empty() && one.of_class == names[kind];
        };
        const bool has_inside = std::any_of(outlines.begin(), outlines.end(), [&](const auto& one) {
            return one.role == Role::inside && is_own(one);
        });
        const double own_border = places.borders.empty() ? places.border : places.borders[kind];
        for (std::size_t i = 0; i < outlines.size(); ++i) {
            const Outline& one = outlines[i];
            const bool is_for_all =
                one.of_class.empty() && (one.role != Role::inside || !has_inside);
            if (!is_for_all && !is_own(one)) continue;
            const bool is_of_objects = places.border_by_radius && one.role == Role::avoid;
            const double distance = one.distance             ? scales[i] * *one.distance
                                    : has_distance(one.role) ? 0
                                                             : own_border;
            kinds_[kind].emplace_back(i, distance + (is_of_objects ? own_border : 0));
        }
        for (std::vector<PolygonSet>& sets = sets_.emplace_back();
             const auto& [i, distance] : kinds_[kind])
            for (std::size_t image = first[i]; image < first[i + 1]; ++image)
                sets.push_back({rings_[image], outlines[i].role, distance});
    }
}

std::size_t Sets::first_like(std::size_t kind) const {
    return static_cast<std::size_t>(std::find(kinds_.begin(), kinds_.end(), kinds_[kind]) -
                                    kinds_.begin());
}

std::span<const PolygonSet> Sets::most() const {
    return *std::max_element(sets_.begin(), sets_.end(),
                             [](const auto& a, const auto& b) { return a.size() < b.size(); });
}

void take_border_by_radius(std::optional<double> radius, const Domain& domain,
                           const Classes& classes, Places& places) {
    if (domain.wraps())
        throw BadRequest("inside-by-radius", "with --torus", "a torus has no edges");
    const std::size_t count = classes.names.size();
    const double shorter = domain.shorter_side();
    // Without a radius, or with one that will be refused, there is no border.
    const double size = radius.value_or(count == 0 ? 0 : least_distance_of(classes));
    const double half = size > 0 && std::isfinite(size) ? size / 2 : 0;
    std::vector<double> radii(std::max<std::size_t>(1, count), half);
    for (std::size_t i = 0; i < count; ++i)
        radii[i] = own_distance_of(classes, i) / least_distance_of(classes) * half;
    for (std::size_t i = 0; i < radii.size(); ++i) {
        if (!(radii[i] >= shorter / 2) || !(shorter > 0) || std::isinf(radii[i])) continue;
        throw BadRequest("inside-by-radius",
                         "with objects" + (count == 0 ? "" : " of class " + classes.names[i]),
                         "their radius is " + shortest(radii[i]) +
                             ": must be under half of the domain's shorter side, " +
                             shortest(shorter / 2) + ", or there is no place for them");
    }
    if (count == 0)
        places.border = radii.front();
    else
        places.borders = std::move(radii);
}

double edge_of_radius(double least_radius) {
    return least_radius / 16;  // keeps masks small, and the error well under the points' distance
}

void check(const Claim& claim) {
    const bool has_border = claim.places.border > 0 || !claim.places.borders.empty();
    for (const Outline& outline : claim.places.outlines) {
        const std::string option(name_of(outline.role));
        check_at_least_0("border", outline.distance.value_or(0));
        for (const PolygonRing& ring : outline.polygons.rings) {
            if (ring.size() < 3 &&
                !((outline.distance.value_or(0) > 0 || has_border) && !ring.empty()))
                throw BadRequest(option, "a ring of " + std::to_string(ring.size()) + " points",
                                 "must have at least 3");
            for (const Point& point : ring)
                if (!std::isfinite(point.x) || !std::isfinite(point.y))
                    throw BadRequest(option,
                                     "(" + shortest(point.x) + ", " + shortest(point.y) + ")",
                                     "must be finite numbers");
        }
    }
    if (claim.places.edge) check_at_least_0("edge", *claim.places.edge);
    if (claim.places.border_by_radius && (claim.field != nullptr || claim.places.mask != nullptr))
        throw BadRequest("inside-by-radius", "with --field or --mask",
                         "is for disks of one size, or of one for each class, and for outlines");
}

std::shared_ptr<const Claim> settled(const Claim& given) {
    struct Owner {
        Claim claim;
        std::shared_ptr<const std::vector<Mask>> masks;
    };
    const Places& places = given.places;
    const bool has_edge = places.edge || places.outlines.empty();
    const bool has_both =
        !places.outlines.empty() && (places.mask != nullptr || !places.masks.empty());
    if (has_edge && !places.border_by_radius && !has_extents(places) && !has_both) return nullptr;
    const auto owner = std::make_shared<Owner>(Owner{given, nullptr});
    const std::shared_ptr<Claim> claim(owner, &owner->claim);
    owner->masks = cut_masks(given.domain, claim->places);
    turn_masks_into_outlines(given.domain, given.classes, claim->places);
    if (given.places.border_by_radius)
        take_border_by_radius(given.radius > 0 ? std::optional(given.radius) : std::nullopt,
                              given.domain, given.classes, claim->places);
    if (has_edge) return claim;
    double least = size_of(given);
    if (given.field != nullptr) {
        const std::vector<double>& importance = given.field->importance;
        least /= std::sqrt(*std::max_element(importance.begin(), importance.end()));
    }
    claim->places.edge = edge_of_radius(least);
    return claim;
}

}  // namespace places
}  // namespace lacuna
