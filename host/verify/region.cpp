// Joins the answers of several outlines.
#include "verify/region.h"

#include <algorithm>
#include <limits>

namespace lacuna::verify {

Region::Region(std::span<const PolygonSet> sets) {
    for (const PolygonSet& set : sets)
        (set.forbidden ? forbidden_ : allowed_).push_back({Outline(set.rings), set.distance});
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
    return all;
}

double Region::depth_of(Point place) const {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    double depth = allowed_.empty() ? kFar : -kFar;
    for (const auto& [outline, distance] : allowed_)
        depth = std::max(depth, outline.depth_of(place) - distance);
    for (const auto& [outline, distance] : forbidden_)
        depth = std::min(depth, -outline.depth_of(place) - distance);
    return depth;
}

}  // namespace lacuna::verify
