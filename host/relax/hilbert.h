// The order of sites along Hilbert's curve.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/polling.h"
#include "relax/lattice.h"

namespace lacuna::relaxing {

// Indices of the sites, so that those near each other are near each other in memory.
std::vector<std::uint32_t> hilbert_order(std::span<const Site> sites, const Poll& poll);

}  // namespace lacuna::relaxing
