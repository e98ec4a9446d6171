// Refuses claims that make no sense, gives each sample its radius, and asks for the worst pair and
// the barest spot.
#include "verify/ground_proof.h"

#include <oneapi/tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/threads.h"
#include "verify/closest_by_limit.h"
#include "verify/emptiest_by_limit.h"
#include "verify/ground.h"
#include "verify/verify.h"

namespace lacuna::verify {
namespace {

void check_field(const Field& field) {
    const std::string size = std::to_string(field.columns) + "x" + std::to_string(field.rows);
    if (field.columns == 0 || field.rows == 0) throw BadRequest("field", size, "must have a pixel");
    if (field.importance.size() != std::size_t{field.columns} * field.rows)
        throw BadRequest(
            "field", size,
            "must have columns * rows values, not " + std::to_string(field.importance.size()));
    for (const double importance : field.importance)
        if (!std::isfinite(importance) || importance < 0)
            throw BadRequest("field", text(importance),
                             "importance must be a finite number of at least 0");
}

void check_mask(const Mask& mask) {
    const std::string size = std::to_string(mask.columns) + "x" + std::to_string(mask.rows);
    if (mask.columns == 0 || mask.rows == 0) throw BadRequest("mask", size, "must have a pixel");
    if (mask.allowed.size() != std::size_t{mask.columns} * mask.rows)
        throw BadRequest(
            "mask", size,
            "must have columns * rows values, not " + std::to_string(mask.allowed.size()));
}

void check_polygons(const Claim& claim) {
    for (const std::vector<Point>& ring : claim.inside) {
        if (ring.size() < 3)
            throw BadRequest("inside", "a ring of " + std::to_string(ring.size()) + " points",
                             "must have at least 3");
        for (const Point& point : ring)
            if (!std::isfinite(point.x) || !std::isfinite(point.y))
                throw BadRequest("inside", "(" + text(point.x) + ", " + text(point.y) + ")",
                                 "must be finite numbers");
    }
    if (!std::isfinite(claim.edge_tolerance) || claim.edge_tolerance < 0)
        throw BadRequest("edge", text(claim.edge_tolerance),
                         "must be a finite number of at least 0");
}

void check_border(const Claim& claim) {
    if (!std::isfinite(claim.border) || claim.border < 0)
        throw BadRequest("border", text(claim.border), "must be a finite number of at least 0");
    if (claim.border > 0 && claim.boundary == Boundary::torus)
        throw BadRequest("border", text(claim.border), "is not for a torus, which has no edges");
}

void check_positive(const char* option, double value) {
    if (!std::isfinite(value) || value <= 0)
        throw BadRequest(option, text(value), "must be a finite number greater than 0");
}

void check_claim(const Claim& claim, double tolerance) {
    check_domain(claim.width, claim.height);
    check_tolerance(tolerance);
    if (claim.field != nullptr) {
        check_field(*claim.field);
        check_positive("scale", claim.scale);
    } else {
        check_positive("radius", claim.radius);
    }
    if (claim.mask != nullptr) check_mask(*claim.mask);
    check_polygons(claim);
    check_border(claim);
}

void check_least_radius(const Ground& ground, const Claim& claim) {
    const double smallest = ground.domain().longer_side() * kSmallestRadius;
    if (ground.least_radius() < smallest)
        throw BadRequest(claim.field != nullptr ? "scale" : "radius",
                         text(claim.field != nullptr ? claim.scale : claim.radius),
                         "gives a least radius of " + text(ground.least_radius()) +
                             ", but it must be at least " + text(smallest) +
                             ", the longer side / 2^32, or doubles run out of digits");
}

// The samples with radii that they may be said to have: the least, and the most.
struct Samples {
    std::vector<Disk> least;
    std::vector<Disk> most;
};

// Finds the first point that may not lie where it does.
Samples samples_of(std::span<const Point> points, const Ground& ground, Proof& proof) {
    Samples samples;
    const auto outside = std::find_if(points.begin(), points.end(),
                                      [&](const Point& p) { return !ground.domain().contains(p); });
    if (outside != points.end()) {
        proof.outside = static_cast<std::size_t>(outside - points.begin());
        return samples;
    }
    samples.least.reserve(points.size());
    samples.most.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto found = ground.radii_of_sample(points[i]);
        if (const auto* closed = std::get_if<Proof::Closed>(&found)) {
            proof.forbidden = i;
            proof.forbidden_by = *closed;
            return samples;
        }
        const SampleRadii radii = std::get<SampleRadii>(found);
        samples.least.push_back({points[i], radii.least});
        samples.most.push_back({points[i], radii.most});
    }
    return samples;
}

void look_at_distances(const Ground& ground, std::span<const Disk> samples,
                       const Patience& patience, Proof& proof) {
    const LimitedPair pair = closest_by_limit(ground.domain(), samples, patience);
    proof.kept = pair.is_kept();
    proof.first = pair.first;
    proof.second = pair.second;
    proof.least_distance = pair.distance;
    proof.least_limit = pair.limit;
}

void look_for_gaps(const Ground& ground, std::span<const Disk> samples, double tolerance,
                   const Patience& patience, Proof& proof) {
    const BareSpot spot = emptiest_by_limit(ground, samples, tolerance, patience);
    proof.covered = spot.over <= tolerance + ground.domain().rounding();
    proof.emptiest = spot.at;
    proof.emptiest_distance = spot.distance;
    proof.emptiest_limit = spot.limit;
}

}  // namespace

std::optional<std::size_t> first_moved(std::span<const Point> points, std::span<const Point> kept) {
    for (std::size_t i = 0; i < kept.size(); ++i)
        if (i >= points.size() || points[i] != kept[i]) return i;
    return std::nullopt;
}

double default_ground_tolerance(double width, double height) {
    return 2 * default_tolerance(width, height);
}

Proof prove_on_ground(std::span<const Point> points, const Claim& claim, const Patience& patience) {
    const double tolerance =
        claim.tolerance.value_or(default_ground_tolerance(claim.width, claim.height));
    check_claim(claim, tolerance);
    const Domain domain{claim.width, claim.height, claim.boundary == Boundary::torus};
    const Field one_pixel{1, 1, {1}};
    const Ground ground(domain, {claim.field != nullptr ? claim.field : &one_pixel,
                                 claim.field != nullptr ? claim.scale : claim.radius, claim.mask,
                                 claim.inside, claim.edge_tolerance, claim.border});
    check_least_radius(ground, claim);

    Proof proof;
    const Samples samples = samples_of(points, ground, proof);
    if (proof.outside || proof.forbidden) return proof;
    if (claim.distances_only) {
        look_at_distances(ground, samples.least, patience, proof);
        return proof;
    }
    make_sure_of_threads();
    oneapi::tbb::parallel_invoke(
        [&] { look_at_distances(ground, samples.least, patience, proof); },
        [&] { look_for_gaps(ground, samples.most, tolerance, patience, proof); });
    proof.maximal =
        proof.kept && proof.covered && tolerance <= kMostTolerance * ground.least_radius();
    return proof;
}

}  // namespace lacuna::verify
