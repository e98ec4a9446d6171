// Finds the lattice point to which a site moves if it would end where there is no importance.
#pragma once

#include <cstdint>

#include "relax/cpu/tile.h"
#include "relax/lattice.h"

namespace lacuna::relaxing::cpu {

// The lattice point with importance that is nearest to `from`: of those assigned to sites[site] or,
// without `must_be_assigned`, of all. One must exist. Ties go to the lowest row, then column.
Site nearest_point(const Scene& scene, std::uint32_t site, bool must_be_assigned, Site from);

}  // namespace lacuna::relaxing::cpu
