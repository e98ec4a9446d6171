// Joins the answers of several outlines.
#include "verify/region.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna::verify {

Region::Region(std::span<const PolygonSet> sets) {
    for (const PolygonSet& set : sets)
        (set.role == Role::near   ? near_
         : is_forbidden(set.role) ? forbidden_
                                  : allowed_)
            .push_back({Outline(set.rings), set.distance});
}

Openness Region::under(const Cell& cell, double clearance) const {
    Openness all{.has_open = allowed_.empty(), .has_closed = !allowed_.empty()};
    for (const auto& [outline, distance] : allowed_) {
        const Openness one = outline.under(cell, clearance + distance);
        all.has_open |= one.has_open;
        all.has_closed &= one.has_closed;
    }
    for (const auto& [outline, distance] : forbidden_) {
        const Openness one = outline.under(cell, clearance + distance, Side::outside);
        all.has_open &= one.has_open;
        all.has_closed |= one.has_closed;
    }
    Openness near{.has_open = near_.empty(), .has_closed = !near_.empty()};
    for (const auto& [outline, distance] : near_) {
        const Openness one = outline.within(cell, distance - clearance);
        near.has_open |= one.has_open;
        near.has_closed &= one.has_closed;
    }
    return {all.has_open && near.has_open, all.has_closed || near.has_closed};
}

double Region::depth_of(Point place) const {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    double depth = allowed_.empty() ? kFar : -kFar;
    for (const auto& [outline, distance] : allowed_)
        depth = std::max(depth, outline.depth_of(place) - distance);
    for (const auto& [outline, distance] : forbidden_)
        depth = std::min(depth, -outline.depth_of(place) - distance);
    double within = near_.empty() ? kFar : -kFar;
    for (const auto& [outline, distance] : near_)
        within = std::max(within, distance - std::abs(outline.depth_of(place)));
    return std::min(depth, within);
}

}  // namespace lacuna::verify
