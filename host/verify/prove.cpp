// Proves or refutes a claim: gives each sample its radius, then asks for the closest pair and the
// largest gap.
#include <lacuna/verify.h>
#include <oneapi/tbb/parallel_invoke.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <tuple>
#include <variant>
#include <vector>

#include "base/threads.h"
#include "verify/closest.h"
#include "verify/closest_unlike.h"
#include "verify/largest_gap.h"
#include "verify/radius_field.h"
#include "verify/verify.h"

namespace lacuna {
namespace verify {
namespace {

std::optional<std::size_t> first_moved(std::span<const Point> points, std::span<const Point> kept) {
    for (std::size_t i = 0; i < kept.size(); ++i)
        if (i >= points.size() || points[i] != kept[i]) return i;
    return std::nullopt;
}

std::optional<std::size_t> first_outside(std::span<const Point> points, const Domain& domain) {
    const auto outside = std::find_if(points.begin(), points.end(),
                                      [&](const Point& p) { return !domain.contains(p); });
    if (outside == points.end()) return std::nullopt;
    return static_cast<std::size_t>(outside - points.begin());
}

// The samples with the smallest and with the largest radius that each may have.
struct Samples {
    std::vector<Disk> least;
    std::vector<Disk> most;
};

// Stops at the first point that lies where no point may, and sets proof.forbidden.
Samples samples_of(std::span<const Point> points, const RadiusField& radius_field, Proof& proof) {
    Samples samples;
    samples.least.reserve(points.size());
    samples.most.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto found = radius_field.radii_of_sample(points[i]);
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

void tell_of(const Pair& pair, double limit, Proof& proof) {
    proof.kept = pair.distance >= limit;
    proof.first = pair.first;
    proof.second = pair.second;
    proof.least_distance = pair.distance;
    proof.least_limit = limit;
}

// `most_over`: how far over the gap's limit a covered spot may be.
void tell_of(const Gap& gap, double most_over, double limit, Proof& proof) {
    proof.covered = gap.over <= most_over;
    proof.largest_gap = gap.at;
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
            tell_of(largest_gap(domain, points, reach, patience), reach + domain.rounding(),
                    claim.radius, proof);
        });
}

void prove_on_field(std::span<const Point> points, const Claim& claim,
                    const RadiusField& radius_field, double tolerance, const Patience& patience,
                    Proof& proof) {
    const Domain& domain = radius_field.domain();
    const Samples samples = samples_of(points, radius_field, proof);
    if (proof.forbidden) return;
    ask(
        claim,
        [&] {
            const Pair pair = closest_pair(domain, samples.least, patience, kHopeless);
            tell_of(pair, pair.limit, proof);
        },
        [&] {
            const Gap gap = largest_gap(radius_field, samples.most, tolerance, patience);
            tell_of(gap, tolerance + domain.rounding(), gap.limit, proof);
        });
}

// Classes: the samples of each, and the distances as shares of the least one that is not 0.
class Kinds {
public:
    Kinds(const Claim& claim, const Samples& samples) : distances_(shares_of(claim)) {
        const std::size_t count = claim.classes.names.size();
        of_class_.resize(count);
        for (std::size_t i = 0; i < samples.least.size(); ++i)
            of_class_[claim.class_of_points[i]].push_back(i);
    }

    std::size_t count() const { return of_class_.size(); }
    double share(std::size_t a, std::size_t b) const { return distances_[a * count() + b]; }
    const std::vector<std::size_t>& samples_of(std::size_t kind) const { return of_class_[kind]; }

    // The samples of one class, with the radii that they have beside another.
    std::vector<Disk> beside(std::size_t kind, std::size_t other,
                             std::span<const Disk> samples) const {
        std::vector<Disk> disks;
        disks.reserve(of_class_[kind].size());
        const double factor = share(kind, other);
        for (const std::size_t i : of_class_[kind])
            disks.push_back({samples[i].at, samples[i].radius * factor, factor});
        return disks;
    }

private:
    std::vector<double> distances_;
    std::vector<std::vector<std::size_t>> of_class_;
};

// The closest pair of all classes: within each, and between each two.
Pair closest_of_kinds(const Domain& domain, const Kinds& kinds, std::span<const Disk> samples,
                      const Patience& patience) {
    Pair closest;
    const auto take = [&](Pair pair, std::size_t first, std::size_t second) {
        if (!(pair.ratio < closest.ratio)) return;
        std::tie(pair.first, pair.second) = std::minmax({first, second});
        closest = pair;
    };
    for (std::size_t a = 0; a < kinds.count(); ++a) {
        const std::vector<std::size_t>& ones = kinds.samples_of(a);
        const Pair own = closest_pair(domain, kinds.beside(a, a, samples), patience, kHopeless);
        if (ones.size() > 1) take(own, ones[own.first], ones[own.second]);
        for (std::size_t b = a + 1; b < kinds.count(); ++b) {
            const std::vector<std::size_t>& others = kinds.samples_of(b);
            if (kinds.share(a, b) == 0 || ones.empty() || others.empty()) continue;
            const Pair pair = closest_unlike(domain, kinds.beside(a, b, samples),
                                             kinds.beside(b, a, samples), closest.ratio, patience);
            if (pair.limit > 0) take(pair, ones[pair.first], others[pair.second]);
        }
    }
    return closest;
}

// Asks for each class that is drawn where one more of its samples would have most room.
void tell_of_gaps(const Claim& claim, const RadiusField& radius_field, const Kinds& kinds,
                  std::span<const Disk> samples, double tolerance, const Patience& patience,
                  Proof& proof) {
    std::optional<Gap> largest;
    for (std::size_t kind = 0; kind < kinds.count(); ++kind) {
        if (!claim.classes.weights.empty() && claim.classes.weights[kind] == 0) continue;
        std::vector<Disk> disks;
        for (std::size_t other = 0; other < kinds.count(); ++other) {
            if (kinds.share(other, kind) == 0) continue;
            const std::vector<Disk> more = kinds.beside(other, kind, samples);
            disks.insert(disks.end(), more.begin(), more.end());
        }
        const Gap gap = largest_gap(radius_field, disks, tolerance, patience);
        if (largest && gap.over <= largest->over) continue;
        largest = gap;
        proof.largest_gap_class = kind;
    }
    if (largest)
        tell_of(*largest, tolerance + radius_field.domain().rounding(), largest->limit, proof);
}

void prove_on_classes(std::span<const Point> points, const Claim& claim,
                      const RadiusField& radius_field, double tolerance, const Patience& patience,
                      Proof& proof) {
    const Samples samples = samples_of(points, radius_field, proof);
    if (proof.forbidden) return;
    const Kinds kinds(claim, samples);
    ask(
        claim,
        [&] {
            const Pair pair =
                closest_of_kinds(radius_field.domain(), kinds, samples.least, patience);
            tell_of(pair, pair.limit, proof);
        },
        [&] {
            tell_of_gaps(claim, radius_field, kinds, samples.most, tolerance, patience, proof);
        });
}

// The radius, or with a field the scale; with classes the least distance, unless the claim has one.
double size_of(const Claim& claim) {
    const double size = claim.field != nullptr ? claim.scale : claim.radius;
    return size > 0 || claim.classes.names.empty() ? size : least_distance(claim.classes);
}

}  // namespace
}  // namespace verify

Proof prove(std::span<const Point> points, const Claim& claim,
            const std::function<bool()>& keep_going) {
    using namespace verify;
    const Patience patience(keep_going);
    const double tolerance = tolerance_of(claim);
    check_claim(claim, points.size(), tolerance);
    Proof proof;
    proof.tolerance = tolerance;
    proof.moved = first_moved(points, claim.keep);
    if (proof.moved) return proof;
    const Domain domain{claim.width, claim.height, claim.boundary == Boundary::torus};
    const Field one_pixel{1, 1, {1}};
    const verify::RadiusField radius_field(
        domain, {.field = claim.field != nullptr ? claim.field : &one_pixel,
                 .scale = size_of(claim),
                 .mask = claim.mask,
                 .polygons = claim.polygons,
                 .edge_tolerance = claim.edge_tolerance,
                 .border = claim.border});
    check_least_radius(claim, radius_field.least_radius());
    proof.outside = first_outside(points, domain);
    if (proof.outside) return proof;
    if (!claim.classes.names.empty()) {
        prove_on_classes(points, claim, radius_field, tolerance, patience, proof);
    } else if (is_uniform(claim)) {
        prove_uniform(points, claim, domain, tolerance, patience, proof);
    } else {
        prove_on_field(points, claim, radius_field, tolerance, patience, proof);
    }
    proof.maximal =
        proof.kept && proof.covered && tolerance <= kMostTolerance * radius_field.least_radius();
    return proof;
}

}  // namespace lacuna
