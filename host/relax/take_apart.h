// Sites on one spot go to free spots around it.
#pragma once

#include <vector>

#include "base/polling.h"
#include "relax/lattice.h"

namespace lacuna::relaxing {

// Sites on one spot would stay together for ever, as one of them owns all that is nearest to both:
// those after the first, by index, go to the nearest free spots around it, a unit apart.
void take_apart(std::vector<Site>& sites, const portable::RelaxLattice& numbers, const Poll& poll);

}  // namespace lacuna::relaxing
