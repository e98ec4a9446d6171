// Joins the answers of several outlines.
#include "verify/region.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna::verify {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

}  // namespace

Region::Region(std::span<const PolygonSet> sets)
    : allowed_(sets, [](Role role) { return role == Role::inside; }),
      forbidden_(sets, is_forbidden),
      near_(sets, [](Role role) { return role == Role::near; }) {}

Region::Outlines::Outlines(std::span<const PolygonSet> sets, bool (*are_wanted)(Role role))
    : kept_(kept_of(sets, are_wanted)), tree_(kept_, [](const Kept& kept) {
          // Without an edge an outline has no say about a cell, wherever its rectangle lies.
          if (kept.outline.is_empty()) return Cell{};
          const Cell& around = kept.outline.around();
          return Cell{around.left - kept.distance, around.right + kept.distance,
                      around.bottom - kept.distance, around.top + kept.distance};
      }) {}

std::vector<Region::Outlines::Kept> Region::Outlines::kept_of(std::span<const PolygonSet> sets,
                                                              bool (*are_wanted)(Role role)) {
    std::vector<Kept> kept;
    for (const PolygonSet& set : sets)
        if (are_wanted(set.role)) kept.push_back({Outline(set.rings), set.distance});
    return kept;
}

template <typename Use>
void Region::Outlines::visit_near(const Cell& cell, double clearance, Use use) const {
    tree_.visit(
        [&](const Cell& around) {
            return squared_distance_between(around, cell) <= square(clearance);
        },
        [&](std::size_t i) { use(kept_[i].outline, kept_[i].distance); });
}

template <typename OfOne>
double Region::Outlines::least(Point place, OfOne of_one) const {
    return tree_.least(
        [&](const Cell& around) {
            const double squared = squared_distance_to(around, place);
            return squared > 0 ? std::sqrt(squared) : -kFar;  // it may be less than the distance
        },
        [&](std::size_t i) { return of_one(kept_[i].outline, kept_[i].distance); });
}

// Outlines that are farther away have nothing to say about the cell: none of it is inside of them,
// nor near to them.
Openness Region::under(const Cell& cell, double clearance) const {
    Openness all{.has_open = allowed_.are_none(), .has_closed = !allowed_.are_none()};
    allowed_.visit_near(cell, clearance, [&](const Outline& outline, double distance) {
        const Openness one = outline.under(cell, clearance + distance);
        all.has_open |= one.has_open;
        all.has_closed &= one.has_closed;
    });
    forbidden_.visit_near(cell, clearance, [&](const Outline& outline, double distance) {
        const Openness one = outline.under(cell, clearance + distance, Side::outside);
        all.has_open &= one.has_open;
        all.has_closed |= one.has_closed;
    });
    Openness near{.has_open = near_.are_none(), .has_closed = !near_.are_none()};
    near_.visit_near(cell, 0, [&](const Outline& outline, double distance) {
        const Openness one = outline.within(cell, distance - clearance);
        near.has_open |= one.has_open;
        near.has_closed &= one.has_closed;
    });
    return {all.has_open && near.has_open, all.has_closed || near.has_closed};
}

double Region::depth_of(Point place) const {
    double depth = kFar;
    if (!allowed_.are_none())
        depth = -allowed_.least(place, [&](const Outline& outline, double distance) {
            return distance - outline.depth_of(place);
        });
    depth = std::min(depth, forbidden_.least(place, [&](const Outline& outline, double distance) {
        return -outline.depth_of(place) - distance;
    }));
    if (near_.are_none()) return depth;
    return std::min(depth, -near_.least(place, [&](const Outline& outline, double distance) {
        return std::abs(outline.depth_of(place)) - distance;
    }));
}

}  // namespace lacuna::verify
