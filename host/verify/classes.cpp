// Proofs for each class, and for each two.
#include "verify/classes.h"

#include <algorithm>
#include <tuple>
#include <vector>

#include "checks/classes.h"
#include "places/sets.h"
#include "verify/closest_unlike.h"
#include "verify/neighbours.h"
#include "verify/verify.h"

namespace lacuna::verify {
namespace {

// Classes: the samples of each, and the distances as shares of the least one that is not 0.
class Kinds {
public:
    explicit Kinds(const Claim& claim) : distances_(distances_of(claim.classes)) {
        const std::size_t count = claim.classes.names.size();
        of_class_.resize(count);
        for (std::size_t i = 0; i < claim.class_of_points.size(); ++i)
            of_class_[claim.class_of_points[i]].push_back(i);
    }

    // Without the samples of the classes behind `last`, but for those that were kept: the first
    // `kept` ones, and all from `members` on.
    void drop_later(std::size_t last, std::size_t kept, std::size_t members) {
        for (std::size_t kind = last + 1; kind < count(); ++kind)
            std::erase_if(of_class_[kind], [&](std::size_t i) { return i >= kept && i < members; });
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

// Polygons from the domain's corner on.
class MovedPolygons {
public:
    MovedPolygons(std::span<const PolygonSet> sets, const Domain& domain)
        : sets_(sets.begin(), sets.end()) {
        if (domain.x0 == 0 && domain.y0 == 0) return;
        rings_.reserve(sets_.size());
        for (PolygonSet& set : sets_) {
            std::vector<PolygonRing>& rings =
                rings_.emplace_back(set.rings.begin(), set.rings.end());
            for (PolygonRing& ring : rings)
                for (Point& point : ring) point = {point.x - domain.x0, point.y - domain.y0};
            set.rings = rings;
        }
    }
    std::span<const PolygonSet> all() const { return sets_; }

private:
    std::vector<std::vector<PolygonRing>> rings_;
    std::vector<PolygonSet> sets_;
};

}  // namespace

Fields::Fields(const Domain& domain, const FieldParts& parts, const Claim& claim) {
    const auto add = [&](FieldParts own, std::span<const PolygonSet> polygons) {
        const MovedPolygons moved(polygons, domain);
        own.polygons = moved.all();
        fields_.emplace_back(domain, own);  // copies the polygons
    };
    const Classes& classes = claim.classes;
    const Places& places = claim.places;
    const bool are_alike = !has_own_places(places);
    const places::Sets sets(places, claim.domain, classes);
    if (are_alike) add(parts, sets[0]);
    for (std::size_t i = 0; !are_alike && i < classes.names.size(); ++i) {
        FieldParts own = parts;
        if (!places.borders.empty()) own.border = places.borders[i];
        if (!places.masks.empty() && places.masks[i] != nullptr) own.mask = places.masks[i];
        add(own, sets[i]);
    }
}

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

GapOfClass largest_gap_of_classes(const Fields& fields, const Claim& claim,
                                  std::span<const Disk> samples, std::size_t members,
                                  double tolerance, const Patience& patience) {
    const Kinds all(claim);
    const Outside outside(claim);
    const auto kept = static_cast<std::size_t>(
        std::count_if(claim.keep.begin(), claim.keep.end(),
                      [&](const Point& point) { return !outside.has(point); }));
    GapOfClass largest{{}, 0};
    for (std::size_t kind = 0; kind < all.count(); ++kind) {
        if (!is_open(claim.classes, kind)) continue;
        Kinds kinds = all;
        if (claim.classes.by_priority)
            kinds.drop_later(kind_of(claim.classes, kind).last, kept, members);
        std::vector<Disk> disks;
        for (std::size_t other = 0; other < kinds.count(); ++other) {
            if (kinds.share(other, kind) == 0) continue;
            const std::vector<Disk> more = kinds.beside(other, kind, samples);
            disks.insert(disks.end(), more.begin(), more.end());
        }
        const Gap gap = largest_gap(fields.of_class(kind), disks, tolerance, patience);
        if (gap.over > largest.gap.over) largest = {gap, kind};
    }
    return largest;
}

}  // namespace lacuna::verify
