// The closest pair of two classes: a sample of the one and a sample of the other.
#pragma once

#include <span>

#include "verify/closest.h"
#include "verify/domain.h"
#include "verify/patience.h"

namespace lacuna::verify {

// Pair::first is an index of `ones`, Pair::second one of `others`. Their limit is the smaller of
// their radii. If no pair has a lower ratio than `below`, the ratio returned is infinite.
Pair closest_unlike(const Domain& domain, std::span<const Disk> ones, std::span<const Disk> others,
                    double below, const Patience& patience = {});

}  // namespace lacuna::verify
