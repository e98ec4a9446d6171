// A first path through the dots, built from the shortest edges.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "stipple/pen/neighbours.h"
#include "stipple/pen/spots.h"

namespace lacuna::pen {

// Orders the spots along a path: takes the shortest edges between neighbours first, at most two for
// a spot and without closing a circle. `neighbours` has the lists of all spots.
std::vector<std::uint32_t> greedy_path(std::span<const Spot> spots, const Neighbours& neighbours);

}  // namespace lacuna::pen
