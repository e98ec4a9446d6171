// Proves or refutes a claim: gives each sample its radius, then asks for the closest pair and the
// largest gap.
#include <lacuna/verify.h>
#include <oneapi/tbb/parallel_invoke.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "base/threads.h"
#include "checks/classes.h"
#include "checks/domain.h"
#include "places/sets.h"
#include "verify/classes.h"
#include "verify/closest.h"
#include "verify/ellipse_samples.h"
#include "verify/largest_gap.h"
#include "verify/neighbours.h"
#include "verify/radius_field.h"
#include "verify/verify.h"

namespace lacuna {
namespace verify {
namespace {

std::optional<std::size_t> first_moved(std::span<const Point> points, const Claim& claim) {
    const Outside outside(claim);
    std::size_t place = 0;
    for (std::size_t i = 0; i < claim.keep.size(); ++i) {
        if (outside.has(claim.keep[i])) continue;
        if (place >= points.size() || points[place] != claim.keep[i]) return i;
        ++place;
    }
    return std::nullopt;
}

std::optional<std::size_t> first_outside(std::span<const Point> points, const Domain& domain) {
    const auto outside = std::find_if(points.begin(), points.end(),
                                      [&](const Point& p) { return !domain.contains(p); });
    if (outside == points.end()) return std::nullopt;
    return static_cast<std::size_t>(outside - points.begin());
}

std::optional<std::size_t> first_miscounted(const Claim& claim) {
    const auto& counts = claim.classes.counts;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const auto count = static_cast<std::uint64_t>(std::count(claim.class_of_points.begin(),
                                                                 claim.class_of_points.end(),
                                                                 static_cast<std::uint8_t>(i)));
        if (counts[i] && *counts[i] != count) return i;
    }
    return std::nullopt;
}

// The samples with the smallest radius that each may have, where they are, for distances; and with
// the largest one, from the domain's corner on, for gaps.
struct Samples {
    std::vector<Disk> least;
    std::vector<Disk> most;
};

// Stops at the first point that lies where no point may, and sets proof.forbidden. Points behind
// the first `members` are neighbours, which may lie anywhere and all have one radius.
Samples samples_of(std::span<const Point> points, std::size_t members, const Claim& claim,
                   const Fields& fields, Proof& proof) {
    Samples samples;
    samples.least.reserve(points.size());
    samples.most.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const RadiusField& radius_field = fields.of_sample(claim, i);
        const Point from_corner = radius_field.domain().from_corner(points[i]);
        if (i >= members) {
            samples.least.push_back({points[i], radius_field.least_radius()});
            samples.most.push_back({from_corner, radius_field.least_radius()});
            continue;
        }
        const auto found = radius_field.radii_of_sample(from_corner);
        if (const auto* closed = std::get_if<Proof::Closed>(&found)) {
            proof.forbidden = i;
            proof.forbidden_by = *closed;
            return samples;
        }
        const SampleRadii radii = std::get<SampleRadii>(found);
        samples.least.push_back({points[i], radii.least});
        samples.most.push_back({from_corner, radii.most});
    }
    return samples;
}

// Points from the domain's corner on.
class Ways {
public:
    Ways(std::span<const Point> points, const Domain& domain) : ways_(points) {
        if (domain.x0 == 0 && domain.y0 == 0) return;
        moved_.reserve(points.size());
        for (const Point& point : points) moved_.push_back(domain.from_corner(point));
        ways_ = moved_;
    }
    std::span<const Point> all() const { return ways_; }

private:
    std::vector<Point> moved_;
    std::span<const Point> ways_;
};

void tell_of(const Pair& pair, double limit, Proof& proof) {
    proof.kept = pair.distance >= limit;
    proof.first = pair.first;
    proof.second = pair.second;
    proof.least_distance = pair.distance;
    proof.least_limit = limit;
}

// `most_over`: how far over the gap's limit a covered spot may be.
void tell_of(const Gap& gap, double most_over, double limit, const Domain& domain, Proof& proof) {
    proof.covered = gap.over <= most_over;
    proof.largest_gap = {domain.x0 + gap.at.x, domain.y0 + gap.at.y};
    proof.largest_gap_distance = gap.distance;
    proof.largest_gap_limit = limit;
}

// Runs both questions side by side, or only the one for the closest pair.
void ask(const Claim& claim, const std::function<void()>& for_closest_pair,
         const std::function<void()>& for_largest_gap) {
    if (claim.distances_only) return for_closest_pair();
    make_sure_of_threads();
    oneapi::tbb::parallel_invoke(for_closest_pair, for_largest_gap);
}

void prove_uniform(std::span<const Point> points, const Claim& claim, const Domain& domain,
                   double tolerance, const Patience& patience, Proof& proof) {
    const double reach = claim.radius + tolerance;
    ask(
        claim, [&] { tell_of(closest_pair(domain, points, patience), claim.radius, proof); },
        [&] {
            tell_of(largest_gap(domain, Ways(points, domain).all(), reach, patience),
                    reach + domain.rounding(), claim.radius, domain, proof);
        });
}

void prove_on_field(std::span<const Point> points, std::size_t members, const Claim& claim,
                    const Fields& fields, double tolerance, const Patience& patience,
                    Proof& proof) {
    const Domain& domain = fields.any().domain();
    const Samples samples = samples_of(points, members, claim, fields, proof);
    if (proof.forbidden) return;
    const bool has_classes = !claim.classes.names.empty();
    ask(
        claim,
        [&] {
            const Pair pair = has_classes
                                  ? closest_of_classes(domain, claim, samples.least, patience)
                                  : closest_pair(domain, samples.least, patience, kHopeless);
            tell_of(pair, pair.limit, proof);
        },
        [&] {
            const auto [gap, of_class] =
                has_classes
                    ? largest_gap_of_classes(fields, claim, samples.most, members, tolerance,
                                             patience)
                    : GapOfClass{largest_gap(fields.any(), samples.most, tolerance, patience), 0};
            tell_of(gap, tolerance + domain.rounding(), gap.limit, domain, proof);
            proof.largest_gap_class = of_class;
        });
}

void prove_on_ellipses(std::span<const Point> points, const Claim& claim,
                       const RadiusField& radius_field, double tolerance, const Patience& patience,
                       Proof& proof) {
    const Domain& domain = radius_field.domain();
    const EllipseSamples samples(points, radius_field, proof);
    if (proof.forbidden) return;
    ask(
        claim,
        [&] {
            const Pair pair = samples.closest_pair(radius_field, patience);
            tell_of(pair, pair.limit, proof);
            proof.kept = pair.ratio >= 1;
        },
        [&] {
            const Gap gap = samples.largest_gap(radius_field, tolerance, patience);
            tell_of(gap, tolerance + domain.rounding(), gap.limit, domain, proof);
        });
}

// The points of a set, and its neighbours behind them.
class WithNeighbours {
public:
    WithNeighbours(std::span<const Point> points, const Claim& claim)
        : claim_(claim), count_(points.size()), neighbours_(neighbours_of(claim)), all_(points) {
        if (neighbours_.points.empty()) return;
        joined_.assign(points.begin(), points.end());
        joined_.insert(joined_.end(), neighbours_.points.begin(), neighbours_.points.end());
        all_ = joined_;
        if (claim.classes.names.empty()) return;
        classes_.assign(claim.class_of_points.begin(), claim.class_of_points.end());
        for (const std::size_t place : neighbours_.places)
            classes_.push_back(claim.keep_classes[place]);
        claim_.class_of_points = classes_;
    }
    std::span<const Point> points() const { return all_; }
    const Claim& claim() const { return claim_; }

    // The number that the proof has for a point.
    std::size_t number_of(std::size_t point) const {
        return point < count_ ? point : count_ + neighbours_.places[point - count_];
    }

private:
    Claim claim_;
    std::size_t count_;
    Neighbours neighbours_;
    std::vector<Point> joined_;
    std::span<const Point> all_;
    std::vector<std::uint8_t> classes_;
};

}  // namespace
}  // namespace verify

Proof prove(std::span<const Point> points, const Claim& given,
            const std::function<bool()>& keep_going) {
    using namespace verify;
    const Patience patience(keep_going);
    const double tolerance = tolerance_of(given);
    check_claim(given, points.size(), tolerance);
    const std::shared_ptr<const Claim> own = places::settled(given);
    const Claim& claim = own ? *own : given;
    Proof proof;
    proof.tolerance = tolerance;
    proof.moved = first_moved(points, claim);
    if (proof.moved) return proof;
    const verify::Domain domain = domain_of(claim.domain);
    const Field one_pixel{1, 1, {1}};
    const Fields fields(domain,
                        {.field = claim.field != nullptr ? claim.field : &one_pixel,
                         .scale = size_of(claim),
                         .mask = claim.places.mask,
                         .polygons = {},
                         .edge_tolerance = claim.places.edge.value_or(0),
                         .border = claim.places.border},
                        claim);
    const verify::RadiusField& radius_field = fields.any();
    check_least_radius(claim, radius_field.least_radius());
    if (radius_field.has_ellipses()) check_longest_ellipse(claim, radius_field.most_radius());
    proof.outside = first_outside(points, domain);
    if (proof.outside) return proof;
    proof.miscounted = first_miscounted(claim);
    if (proof.miscounted) return proof;
    const WithNeighbours all(points, claim);
    if (is_uniform(claim)) {
        prove_uniform(all.points(), claim, domain, tolerance, patience, proof);
    } else if (radius_field.has_ellipses()) {
        prove_on_ellipses(points, claim, radius_field, tolerance, patience, proof);
    } else {
        prove_on_field(all.points(), points.size(), all.claim(), fields, tolerance, patience,
                       proof);
    }
    if (all.points().size() > 1) {
        proof.first = all.number_of(proof.first);
        proof.second = all.number_of(proof.second);
    }
    proof.maximal = proof.kept && proof.covered && has_open_class(claim.classes) &&
                    tolerance <= kMostTolerance * radius_field.least_radius();
    return proof;
}

double least_distance(std::span<const Point> points, const Domain& domain) {
    check_domain(domain);
    const verify::Domain its = verify::domain_of(domain);
    if (const auto outside = verify::first_outside(points, its))
        throw BadRequest("points", std::to_string(*outside),
                         "is the number of a point outside of "
                         "the domain");
    return verify::closest_pair(its, points).distance;
}

}  // namespace lacuna
