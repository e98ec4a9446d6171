// Proofs for each class, and for each two.
#include "verify/classes.h"

#include <algorithm>
#include <tuple>
#include <vector>

#include "verify/closest_unlike.h"
#include "verify/verify.h"

namespace lacuna::verify {
namespace {

// Classes: the samples of each, and the distances as shares of the least one that is not 0.
class Kinds {
public:
    explicit Kinds(const Claim& claim) : distances_(shares_of(claim)) {
        const std::size_t count = claim.classes.names.size();
        of_class_.resize(count);
        for (std::size_t i = 0; i < claim.class_of_points.size(); ++i)
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

}  // namespace

// The closest pair of all classes: within each, and between each two.
Pair closest_of_classes(const Domain& domain, const Claim& claim, std::span<const Disk> samples,
                        const Patience& patience) {
    const Kinds kinds(claim);
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

GapOfClass largest_gap_of_classes(const RadiusField& radius_field, const Claim& claim,
                                  std::span<const Disk> samples, double tolerance,
                                  const Patience& patience) {
    const Kinds kinds(claim);
    GapOfClass largest{{}, 0};
    for (std::size_t kind = 0; kind < kinds.count(); ++kind) {
        if (!claim.classes.weights.empty() && claim.classes.weights[kind] == 0) continue;
        std::vector<Disk> disks;
        for (std::size_t other = 0; other < kinds.count(); ++other) {
            if (kinds.share(other, kind) == 0) continue;
            const std::vector<Disk> more = kinds.beside(other, kind, samples);
            disks.insert(disks.end(), more.begin(), more.end());
        }
        const Gap gap = largest_gap(radius_field, disks, tolerance, patience);
        if (gap.over > largest.gap.over) largest = {gap, kind};
    }
    return largest;
}

}  // namespace lacuna::verify
