// Joins the answers of several outlines.
#include "verify/region.h"

#include <algorithm>
#include <limits>

namespace lacuna::verify {

Region::Region(std::span<const PolygonSet> sets) {
    for (const PolygonSet& set : sets)
        (set.forbidden ? forbidden_ : allowed_).emplace_back(set.rings);
}

Openness Region::under(const Cell& cell, double clearance) const {
    Openness all{.has_open = allowed_.empty(), .has_closed = !allowed_.empty()};
    for (const Outline& outline : allowed_) {
        const Openness one = outline.under(cell, clearance);
        all.has_open |= one.has_open;
        all.has_closed &= one.has_closed;
    }
    for (const Outline& outline : forbidden_) {
        const Openness one = outline.under(cell, clearance, Side::outside);
        all.has_open &= one.has_open;
        all.has_closed |= one.has_closed;
    }
    return all;
}

double Region::depth_of(Point place) const {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    double depth = allowed_.empty() ? kFar : -kFar;
    for (const Outline& outline : allowed_) depth = std::max(depth, outline.depth_of(place));
    for (const Outline& outline : forbidden_) depth = std::min(depth, -outline.depth_of(place));
    return depth;
}

}  // namespace lacuna::verify
