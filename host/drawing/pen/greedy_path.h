// A first path through the dots: shortest edges first.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "drawing/pen/neighbours.h"
#include "drawing/pen/spots.h"

namespace lacuna::pen {

// The spots in the order of a path that has been made by taking the shortest edges first, among
// those to near spots: each spot gets two, no circle is closed. `neighbours` are of all spots.
std::vector<std::uint32_t> greedy_path(std::span<const Spot> spots, const Neighbours& neighbours);

}  // namespace lacuna::pen
