// The closest pair and the largest gap of samples in classes.
#pragma once

#include <lacuna/verify.h>

#include <cstddef>
#include <span>

#include "verify/closest.h"
#include "verify/largest_gap.h"
#include "verify/patience.h"
#include "verify/radius_field.h"

namespace lacuna::verify {

// The samples are in the order of Claim::class_of_points, each with its radius for the least
// distance of all classes.
Pair closest_of_classes(const Domain& domain, const Claim& claim, std::span<const Disk> samples,
                        const Patience& patience);

// The largest gap of the classes that are drawn, and the class for which it is.
struct GapOfClass {
    Gap gap;
    std::size_t of_class;
};
GapOfClass largest_gap_of_classes(const RadiusField& radius_field, const Claim& claim,
                                  std::span<const Disk> samples, double tolerance,
                                  const Patience& patience);

}  // namespace lacuna::verify
