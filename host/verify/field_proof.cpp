// Refuses fields that make no sense, gives each sample its radius, and asks for the worst pair and
// the barest spot.
#include "verify/field_proof.h"

#include <oneapi/tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "threads.h"
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

void check_scale(double scale) {
    if (!std::isfinite(scale) || scale <= 0)
        throw BadRequest("scale", text(scale), "must be a finite number greater than 0");
}

void check_least_radius(const Ground& ground, double scale) {
    const double smallest = ground.domain().longer_side() * kSmallestRadius;
    if (ground.least_radius() < smallest)
        throw BadRequest("scale", text(scale),
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
        const auto radii = ground.radii_of_sample(points[i]);
        if (!radii) {
            proof.forbidden = i;
            return samples;
        }
        samples.least.push_back({points[i], radii->least});
        samples.most.push_back({points[i], radii->most});
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

double default_field_tolerance(double width, double height) {
    return 2 * default_tolerance(width, height);
}

Proof prove_field(std::span<const Point> points, const Claim& claim, const Patience& patience) {
    check_domain(claim.width, claim.height);
    const double tolerance =
        claim.tolerance.value_or(default_field_tolerance(claim.width, claim.height));
    check_tolerance(tolerance);
    check_field(*claim.field);
    check_scale(claim.scale);
    const Domain domain{claim.width, claim.height, claim.boundary == Boundary::torus};
    const Ground ground(domain, *claim.field, claim.scale);
    check_least_radius(ground, claim.scale);

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
