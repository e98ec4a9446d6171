// Progressive order: a sequence of which every prefix is as even as a set of its own size (McCool &
// Fiume 1992). A maximal set at a large radius is kept, then comes one at a smaller radius, and so
// on: the radii are levels.
#pragma once

#include <lacuna/lacuna.h>

#include "base/polling.h"

namespace lacuna {

// Makes the sequence down to the request's radius or scale, or until it has request.count points.
// The request must have been checked.
Result progressive(const Request& request, Observer& observer, const Poll& poll);

}  // namespace lacuna
