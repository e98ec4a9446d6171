// The lattice point of importance to which a sample goes that would end where there is none.
#pragma once

#include <cstdint>

#include "relax/cpu/tile.h"
#include "relax/lattice.h"

namespace lacuna::relaxing::cpu {

// The one nearest to `from` of those that scene.sites[site] owns, or with `must_be_assigned` false
// of all; ties go to the lowest row, then column. There must be one.
Site nearest_point(const Scene& scene, std::uint32_t site, bool must_be_assigned, Site from);

}  // namespace lacuna::relaxing::cpu
