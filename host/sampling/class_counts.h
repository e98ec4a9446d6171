// Sets in which some classes have a number of points (Classes::counts).
#pragma once

#include <lacuna/lacuna.h>

#include "base/polling.h"
#include "plan/checked_request.h"

namespace lacuna {

// Draws from the classes that have a number until each has as many points, and then from the
// others. Throws BadRequest if a class has room for fewer points.
Result sample_with_counts(const CheckedRequest& request, Observer& observer, const Poll& poll);

}  // namespace lacuna
