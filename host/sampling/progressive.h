// Progressive order: a sequence of which every prefix is as even as a set of its own size (McCool &
// Fiume 1992). A maximal set at a large radius is kept, then comes one at a smaller radius, and so
// on: the radii are levels.
#pragma once

#include <lacuna/lacuna.h>

#include "base/polling.h"
#include "plan/checked_request.h"

namespace lacuna {

// From level to level radii shrink by 2^(-1/32). With 2^(-1/16) it takes half as long, but 14 of
// 200 sequences have a prefix whose least distance is under 0.7 of a hexagonal lattice's, not 2.
inline constexpr int kLevelsPerHalving = 32;
// The first level has about 16 points. If it had 1, each later sample would fill the deepest hole,
// which makes lattices of 2, 4, 8, ... points. After such a lattice, radii shrink for many levels
// before a sample fits, and the relative distance falls to 0.65.
inline constexpr double kFirstPoints = 16;

// Makes the sequence down to the request's radius or scale, or until it has request.count points.
Result progressive(const CheckedRequest& request, Observer& observer, const Poll& poll);

}  // namespace lacuna
