// The closest pair: the two samples of a set whose distance is the smallest share of their limit.
#pragma once

#include <lacuna/lacuna.h>

#include <cstddef>
#include <limits>
#include <span>

#include "verify/domain.h"
#include "verify/ellipse.h"
#include "verify/patience.h"

namespace lacuna::verify {

// Two samples must keep their limit apart: the smaller of their two radii.
struct Pair {
    std::size_t first = 0;  // less than `second`
    std::size_t second = 0;
    double distance = std::numeric_limits<double>::infinity();  // infinite for fewer than 2 samples
    double limit = 0;  // with ellipses: the smaller radius along the way between the two
    double ratio = std::numeric_limits<double>::infinity();  // distance / limit
};

// For sets on a radius field, closest_pair takes this as `hopeless`: a pair at a millionth of its
// limit is as bad as one that coincides.
constexpr double kHopeless = 1e-6;

// The pair of the least ratio. If several pairs have it, the pair of lowest indices is returned, or
// any pair if they coincide.
// If a ratio is below `hopeless`, another pair may be returned. Samples are taken from the largest
// radius down until a pair of them has such a ratio; the closest pair of these is returned.
// All samples must lie in a torus, anywhere beside a box, and all radii are positive. Never
// compares all pairs, however crowded the samples are and whatever their radii.
Pair closest_pair(const Domain& domain, std::span<const Disk> samples,
                  const Patience& patience = {}, double hopeless = 0);

// The same with ellipses. The ratio is the length of the way from one sample to the other, in units
// of the ellipse's radius along it: the largest one of all ellipses that the two may have. On a
// torus no ellipse is longer than the shorter side.
Pair closest_pair(const Domain& domain, std::span<const BlurredEllipse> samples,
                  const Patience& patience = {}, double hopeless = 0);

// The same for one radius everywhere: the two points at the least distance. Their limit is 1.
Pair closest_pair(const Domain& domain, std::span<const Point> points,
                  const Patience& patience = {});

}  // namespace lacuna::verify
