// The largest gap: the spot that is farthest from all samples, in terms of its limit.
#pragma once

#include <lacuna/lacuna.h>

#include <limits>
#include <span>

#include "verify/domain.h"
#include "verify/patience.h"
#include "verify/radius_field.h"

namespace lacuna::verify {

// The largest gap is found to this share of its size.
constexpr double kGapPrecision = 1e-6;

// A spot is covered by a sample if its distance is at most their limit: the smaller radius of the
// two.
struct Gap {
    Point at{0, 0};
    // The radius at the spot. It is taken from the cell whose centre the spot is. The spot itself
    // may be on the next pixel, because rounding may put a very narrow cell's centre on a side.
    double radius = 0;
    const EllipseShape* shape = nullptr;  // the same with ellipses: the one at the spot
    // The distance and the limit to the sample that covers the spot best, if there is a sample.
    double distance = std::numeric_limits<double>::infinity();
    double limit = 0;
    // distance - limit, with ellipses Ellipse::over; -infinity if no sample may lie anywhere.
    double over = -std::numeric_limits<double>::infinity();
};

// Among the spots where samples may lie, the one that is farthest over its limit. This is sure:
//   - If `over` is more than `tolerance`, no spot is farther over its limit than `over`, with a
//     relative error of kGapPrecision or an error of kFinest of the longer side.
//   - Otherwise no spot is over by more than `tolerance`, with an error of kFinest of the side.
// All samples must lie in the domain or, if it is a box, near it. Where every spot is covered, any
// spot is returned.
Gap largest_gap(const RadiusField& radius_field, std::span<const Disk> samples, double tolerance,
                const Patience& patience = {});

// The same with ellipses. A spot is over its limit by Ellipse::over, and the limit is the smaller
// radius of the two ellipses along the way from the sample to the spot. On a torus no ellipse is
// longer than the shorter side. A sample may be given several times, with different ellipses.
Gap largest_gap(const RadiusField& radius_field, std::span<const Ellipse> samples, double tolerance,
                const Patience& patience = {});

// The same for one radius everywhere, with limits of 0: `over` is the distance to the nearest
// point, and a spot is covered up to a distance of `reach`. Here the gap is the largest one, to
// kGapPrecision, even where every spot is covered, and does not depend on the order of the points.
Gap largest_gap(const Domain& domain, std::span<const Point> points, double reach,
                const Patience& patience = {});

}  // namespace lacuna::verify
