// Sets that are made in stages, in which only some classes are drawn: some classes have a number of
// points (Classes::counts), or each comes before the next (Classes::by_priority).
#pragma once

#include <lacuna/lacuna.h>

#include "base/polling.h"
#include "plan/checked_request.h"

namespace lacuna {

// Draws from the classes that have a number until each has as many points, and then from the
// others; by priority, from one class after the other. Throws BadRequest if a class has room for
// fewer points than its number.
Result sample_in_stages(const CheckedRequest& request, Observer& observer, const Poll& poll);

}  // namespace lacuna
