// Samples with all the ellipses that they may have.
#pragma once

#include <lacuna/lacuna.h>
#include <lacuna/verify.h>

#include <span>
#include <vector>

#include "verify/closest.h"
#include "verify/ellipse.h"
#include "verify/largest_gap.h"
#include "verify/patience.h"
#include "verify/radius_field.h"

namespace lacuna::verify {

// Refers to the ellipses of the radius field, which must outlive this and is the one to ask with.
class EllipseSamples {
public:
    // Stops at the first point that lies where no point may, and sets proof.forbidden.
    EllipseSamples(std::span<const Point> points, const RadiusField& radius_field, Proof& proof);
    EllipseSamples(const EllipseSamples&) = delete;
    EllipseSamples& operator=(const EllipseSamples&) = delete;

    Pair closest_pair(const RadiusField& radius_field, const Patience& patience) const;
    Gap largest_gap(const RadiusField& radius_field, double tolerance,
                    const Patience& patience) const;

private:
    std::vector<const EllipseShape*> shapes_;  // that blurred_ refers to
    // For distances: the samples in the order of the points.
    std::vector<BlurredEllipse> blurred_;
    // For gaps: a sample covers what it covers with any of its ellipses. So each of these makes a
    // sample of its own.
    std::vector<Ellipse> each_;
};

}  // namespace lacuna::verify
