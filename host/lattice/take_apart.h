// Moves sites that have the same position to free positions nearby.
#pragma once

#include <vector>

#include "base/polling.h"
#include "lattice/lattice.h"

namespace lacuna::relaxing {

// Sites at one position would stay together for ever: one of them gets all lattice points near it.
// So all but the first, by index, move to the nearest free positions, a unit apart.
void take_apart(std::vector<Site>& sites, const portable::RelaxLattice& numbers, const Poll& poll);

}  // namespace lacuna::relaxing
