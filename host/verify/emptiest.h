// The emptiest spot of a set: the centre of the largest circle without a point in it.
#pragma once

#include <lacuna/lacuna.h>

#include <limits>
#include <span>

#include "verify/domain.h"
#include "verify/patience.h"

namespace lacuna::verify {

struct Spot {
    Point at{0, 0};
    double distance = std::numeric_limits<double>::infinity();  // to the nearest point, if any
};

// The least difference that decides whether a spot is covered, as a share of the longer side.
constexpr double kFinest = 1e-12;

// How near to the emptiest the spot is that emptiest_spot gives, as a share of its distance.
constexpr double kSpotPrecision = 1e-6;

// The spot of the domain, edges and corners included, that is farthest from every point, on a torus
// with all images of it. All points must lie in the domain. What is sure:
//   - no spot's distance is more than kSpotPrecision over that of the one returned;
//   - when that is at most `limit`, no spot's is over `limit`, but for kFinest of the longer side.
Spot emptiest_spot(const Domain& domain, std::span<const Point> points, double limit,
                   const Patience& patience = {});

}  // namespace lacuna::verify
