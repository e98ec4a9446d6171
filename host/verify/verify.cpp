// Refuses claims that make no sense.
#include "verify/verify.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <utility>

#include "base/number_text.h"
#include "checks/classes.h"
#include "checks/domain.h"
#include "checks/numbers.h"
#include "checks/pixels.h"
#include "places/sets.h"
#include "verify/neighbours.h"

namespace lacuna::verify {
namespace {

void check_mask(const Mask* mask) {
    if (mask == nullptr) return;
    if (mask->drawn)
        throw BadRequest("mask", "drawn from polygons", "give the polygons themselves");
    lacuna::check_mask(*mask);
}

// Where points may lie.
void check_places(const Claim& claim) {
    const Places& places = claim.places;
    check_each(claim.classes, "border", places.borders.size(), " borders of classes");
    check_each(claim.classes, "mask", places.masks.size(), " masks of classes");
    check_mask(places.mask);
    for (const Mask* const mask : places.masks) check_mask(mask);
    places::check(claim);
    check_border(claim.domain, places.border, shortest(places.border));
    for (const double border : places.borders) check_border(claim.domain, border, shortest(border));
}

}  // namespace

namespace {

// What samplers ask of classes besides, such as names without commas, is no matter of a proof.
void check_classes(const Claim& claim, std::size_t points) {
    const Classes& classes = claim.classes;
    check_priority(classes);
    if (classes.names.empty()) return;
    check_distances(classes);
    check_each(classes, "class", classes.weights.size(), " weights");
    check_each(classes, "class", classes.counts.size(), " numbers of points");
    check_classes_of_points(classes, "class", points, claim.class_of_points);
}

void check_neighbours(const Claim& claim) {
    const Outside outside(claim);
    const auto is_one = [&](Point kept) { return outside.has(kept); };
    const auto first = std::find_if(claim.keep.begin(), claim.keep.end(), is_one);
    if (first == claim.keep.end()) return;
    if (!std::isfinite(first->x) || !std::isfinite(first->y) || claim.field != nullptr)
        throw BadRequest("keep",
                         "point " + std::to_string(first - claim.keep.begin()) + " at (" +
                             shortest(first->x) + ", " + shortest(first->y) + ")",
                         claim.field != nullptr ? "with a field must lie in the domain"
                                                : "must be finite numbers");
    if (!claim.classes.names.empty())
        check_classes_of_points(claim.classes, "keep", claim.keep.size(), claim.keep_classes);
}

}  // namespace

void check_claim(const Claim& claim, std::size_t points, double tolerance) {
    check_domain(claim.domain);
    const bool has_classes = !claim.classes.names.empty();
    if (claim.field != nullptr) {
        check_values(*claim.field);
        check_stretches(*claim.field);
        if (has_classes && !claim.field->stretches.empty())
            throw BadRequest("class", "with ellipses", "classes have disks");
        if (!has_classes || claim.scale != 0) check_positive("scale", claim.scale);
    } else if (!has_classes || claim.radius != 0) {
        check_positive("radius", claim.radius);
    }
    check_classes(claim, points);
    check_neighbours(claim);
    // Without gaps to look for, a uniform set needs no tolerance.
    if (!is_uniform(claim) || !claim.distances_only) check_at_least_0("tolerance", tolerance);
    check_places(claim);
}

void check_least_radius(const Claim& claim, double least_radius) {
    const double smallest = claim.domain.longer_side() * kSmallestProvenRadius;
    if (least_radius >= smallest) return;
    const std::string found =
        is_uniform(claim) ? "" : "gives a least radius of " + shortest(least_radius) + ", but it ";
    throw BadRequest(claim.field != nullptr ? "scale" : "radius",
                     shortest(claim.field != nullptr ? claim.scale : claim.radius),
                     found + "must be at least " + shortest(smallest) +
                         ", the longer side / 2^32, or doubles run out of digits");
}

void check_longest_ellipse(const Claim& claim, double longest_radius) {
    const double shorter_side = claim.domain.shorter_side();
    constexpr double kSlack = 1 + 1e-12;  // for the rounding of the radius
    if (!claim.domain.wraps() || 2 * longest_radius <= shorter_side * kSlack) return;
    throw BadRequest("torus", "with an ellipse of length " + shortest(2 * longest_radius),
                     "must be at most the domain's shorter side, " + shortest(shorter_side));
}

bool is_uniform(const Claim& claim) {
    return claim.field == nullptr && claim.places.mask == nullptr &&
           claim.places.outlines.empty() && !claim.places.border_by_radius &&
           claim.places.border == 0 && claim.classes.names.empty();
}

double tolerance_of(const Claim& claim) {
    const double units = neighbours_of(claim).longer_side * 0x1p-28;
    if (!claim.tolerance && !claim.classes.distances.empty()) {
        const std::vector<double> shares = distances_of(claim.classes);
        const std::size_t count = claim.classes.names.size();
        const double coarser = count <= 4 ? 1 : count <= 8 ? 2 : 4;
        return 2 * units * coarser * *std::max_element(shares.begin(), shares.end());
    }
    const bool is_plain = is_uniform(claim) && claim.keep.empty();
    return claim.tolerance.value_or(is_plain ? units : 2 * units);
}

}  // namespace lacuna::verify
