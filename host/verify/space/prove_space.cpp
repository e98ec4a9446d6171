// Proves or refutes sets of points in space: on the surface of a mesh, or in a volume.
#include <lacuna/space.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "checks/numbers.h"
#include "checks/space.h"
#include "verify/patience.h"
#include "verify/space/cells.h"
#include "verify/space/points_in_space.h"
#include "verify/verify.h"

namespace lacuna {
namespace verify::space {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

void check(std::span<const Point3> points, const SpaceClaim& claim) {
    check_positive("radius", claim.radius);
    if (claim.mesh != nullptr)
        check_mesh(*claim.mesh);
    else
        check_volume(claim.volume);
    if (claim.tolerance) check_positive("tolerance", *claim.tolerance);
    check_points(points, "points");
}

// The volume, or the box around the mesh.
BoxCell box_of(const SpaceClaim& claim) {
    if (claim.mesh == nullptr)
        return {{0, 0, 0}, {claim.volume.width, claim.volume.height, claim.volume.depth}};
    const Mesh& mesh = *claim.mesh;
    BoxCell box{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t vertex : triangle) box.add(mesh.vertices[vertex]);
    return box;
}

// Calls `visit` with parts of the surface or the volume whose radius is at most `most`.
template <class Visit>
void for_each_part(const SpaceClaim& claim, double most, const Visit& visit) {
    const auto split = [&](const auto& self, const auto& cell) -> void {
        if (cell.radius() <= most) return visit(cell);
        for (const auto& part : cell.parts()) self(self, part);
    };
    if (claim.mesh == nullptr) return split(split, box_of(claim));
    for (const auto& [a, b, c] : claim.mesh->triangles)
        split(split, TriangleCell{{claim.mesh->vertices[a], claim.mesh->vertices[b],
                                   claim.mesh->vertices[c]}});
}

// The first point that is farther than the tolerance from the surface, or outside of the volume.
std::optional<std::size_t> first_outside(std::span<const Point3> points, const SpaceClaim& claim,
                                         const PointsInSpace& index, double tolerance,
                                         const Patience& patience) {
    std::vector<bool> is_on(points.size());
    if (claim.mesh != nullptr) {
        for_each_part(claim, index.side(), [&](const auto& cell) {
            patience.look();
            const double reach = cell.radius() + tolerance;
            index.for_each_near(cell.centre(), reach, [&](std::size_t i, const Point3& at) {
                if (!is_on[i]) is_on[i] = cell.distance_to(at) <= tolerance;
            });
        });
    } else {
        const BoxCell box = box_of(claim);
        const bool wraps = claim.volume.boundary == Boundary::torus;
        for (std::size_t i = 0; i < points.size(); ++i)
            is_on[i] = wraps ? box.has_below(points[i]) : box.has(points[i]);
    }
    const auto found = std::find(is_on.begin(), is_on.end(), false);
    if (found == is_on.end()) return std::nullopt;
    return static_cast<std::size_t>(found - is_on.begin());
}

// Looks for the spot that is farthest from all points. A cell is dropped if none of its spots can
// be farther by more than within() than the farthest one so far.
class GapSearch {
public:
    GapSearch(const PointsInSpace& points, double radius, double tolerance,
              const Patience& patience)
        : points_(points), radius_(radius), tolerance_(tolerance), patience_(patience) {}

    // The middle of a cell, for all cells before the search: the farther the farthest spot so far,
    // the more is dropped.
    template <class Cell>
    void begin(const Cell& cell) {
        patience_.look();
        note(cell.centre(), points_.distance_to_nearest(cell.centre()));
    }
    template <class Cell>
    void search(const Cell& cell) {
        patience_.look();
        near_.clear();
        points_.for_each_that_may_be_nearest(cell.centre(), cell.radius(),
                                             [&](const Point3& at) { near_.push_back(at); });
        narrow(cell, 0, near_.size());
    }

    const Point3& at() const { return at_; }
    double distance() const { return distance_; }
    // How far over the distance any spot may be. Where it is clear whether the spot is covered, it
    // need not be known to the last digit how far off it is. The sum of both grows with the
    // distance, so what was dropped before would be dropped at the end.
    double within() const { return std::max(tolerance_ / 2, std::abs(distance_ - radius_) / 1024); }

private:
    void note(const Point3& spot, double distance) {
        if (!(distance > distance_)) return;
        distance_ = distance;
        at_ = spot;
    }

    // The points from `begin` to `end` of near_ are all that may be nearest to a spot of the cell.
    template <class Cell>
    void narrow(const Cell& cell, std::size_t begin, std::size_t end) {
        const Point3 centre = cell.centre();
        const double radius = cell.radius();
        double nearest = PointsInSpace::kFar;
        for (std::size_t i = begin; i < end; ++i)
            nearest = std::min(nearest, distance_of(centre, near_[i]));
        note(centre, nearest);
        if (most_in(cell, begin, end) <= distance_ + within()) return;
        for (std::size_t i = begin; i < end; ++i)
            if (distance_of(centre, near_[i]) <= (nearest + 2 * radius) * kRoundedUp)
                near_.push_back(near_[i]);
        const std::size_t kept = near_.size();
        // The part that may have the farthest spot comes first.
        const auto parts = cell.parts();
        std::array<std::pair<double, std::size_t>, parts.size()> order;
        for (std::size_t i = 0; i < parts.size(); ++i)
            order[i] = {-most_in(parts[i], end, kept), i};
        std::sort(order.begin(), order.end());
        for (const auto& [most, i] : order)
            if (-most > distance_ + within()) narrow(parts[i], end, kept);
        near_.resize(end);
    }

    // No spot of the cell is farther from the point that is nearest to it.
    template <class Cell>
    double most_in(const Cell& cell, std::size_t begin, std::size_t end) const {
        double most = PointsInSpace::kFar;
        for (std::size_t i = begin; i < end; ++i) most = std::min(most, cell.farthest(near_[i]));
        return most;
    }

    static constexpr double kRoundedUp = 1 + 0x1p-40;
    const PointsInSpace& points_;
    double radius_;
    double tolerance_;
    const Patience& patience_;
    std::vector<Point3> near_;
    Point3 at_{};
    double distance_ = 0;
};

}  // namespace
}  // namespace verify::space

SpaceProof prove(std::span<const Point3> points, const SpaceClaim& claim,
                 const std::function<bool()>& keep_going) {
    using namespace verify::space;
    const verify::Patience patience(keep_going);
    check(points, claim);
    const BoxCell box = box_of(claim);
    SpaceProof proof;
    proof.tolerance = claim.tolerance.value_or(box.longest_side() * 0x1p-28);
    const bool wraps = claim.mesh == nullptr && claim.volume.boundary == Boundary::torus;
    const PointsInSpace index(points, box, wraps, claim.radius, patience);
    proof.outside = first_outside(points, claim, index, proof.tolerance, patience);
    if (proof.outside) return proof;
    const auto [first, second, least] = index.closest_pair();
    proof.first = first;
    proof.second = second;
    proof.least_distance = least;
    proof.kept = least >= claim.radius;
    if (claim.distances_only) return proof;
    GapSearch gaps(index, claim.radius, proof.tolerance, patience);
    if (points.empty()) proof.largest_gap_distance = kInfinity;
    if (!points.empty()) {
        for_each_part(claim, index.side(), [&](const auto& cell) { gaps.begin(cell); });
        for_each_part(claim, index.side(), [&](const auto& cell) { gaps.search(cell); });
        proof.largest_gap_distance = gaps.distance();
    }
    proof.largest_gap = gaps.at();
    proof.covered = proof.largest_gap_distance + gaps.within() <= claim.radius + proof.tolerance;
    proof.maximal =
        proof.kept && proof.covered && proof.tolerance <= verify::kMostTolerance * claim.radius;
    return proof;
}

}  // namespace lacuna
