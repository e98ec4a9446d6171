// Finds the kept points that lie outside, but no farther than the greatest distance of the claim.
#include "verify/neighbours.h"

#include <algorithm>
#include <cmath>

#include "checks/classes.h"
#include "verify/verify.h"

namespace lacuna::verify {
namespace {

double greatest_distance(const Claim& claim) {
    const std::vector<double>& distances = claim.classes.distances;
    if (distances.empty()) return claim.radius;
    const double greatest = *std::max_element(distances.begin(), distances.end());
    return claim.radius > 0 ? greatest * (claim.radius / least_distance_of(claim.classes))
                            : greatest;
}

}  // namespace

Outside::Outside(const Claim& claim)
    : domain_(domain_of(claim.domain)),
      has_any_(!domain_.torus && !std::all_of(claim.keep.begin(), claim.keep.end(),
                                              [&](Point at) { return domain_.contains(at); })) {}

bool Outside::has(Point kept) const {
    return has_any_ && (!domain_.contains(kept) || kept.x >= domain_.x0 + domain_.width ||
                        kept.y >= domain_.y0 + domain_.height);
}

Neighbours neighbours_of(const Claim& claim) {
    const double left = claim.domain.x0, right = left + claim.domain.width;
    const double bottom = claim.domain.y0, top = bottom + claim.domain.height;
    const double reach = greatest_distance(claim);
    const Outside outside(claim);
    Neighbours found;
    Point low{left, bottom}, high{right, top};
    for (std::size_t i = 0; i < claim.keep.size(); ++i) {
        const Point at = claim.keep[i];
        const double across = std::max({left - at.x, 0.0, at.x - right});
        const double up = std::max({bottom - at.y, 0.0, at.y - top});
        const bool is_near = std::sqrt(across * across + up * up) <= reach;
        if (!is_near || !outside.has(at)) continue;
        found.points.push_back(at);
        found.places.push_back(i);
        low = {std::min(low.x, at.x), std::min(low.y, at.y)};
        high = {std::max(high.x, at.x), std::max(high.y, at.y)};
    }
    found.longer_side = found.points.empty() ? claim.domain.longer_side()
                                             : std::max(high.x - low.x, high.y - low.y);
    return found;
}

}  // namespace lacuna::verify
