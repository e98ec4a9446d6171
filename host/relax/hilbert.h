// Orders sites along Hilbert's curve.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/polling.h"
#include "lattice/lattice.h"

namespace lacuna::relaxing {

// Returns the sites' indices in an order in which near sites are near in memory.
std::vector<std::uint32_t> hilbert_order(std::span<const Site> sites, const Poll& poll);

}  // namespace lacuna::relaxing
