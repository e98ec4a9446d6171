// What decides which points are made, for reports and for files that say how their set was made.
#pragma once

#include <lacuna/lacuna.h>

#include <string>
#include <utility>
#include <vector>

#include "options/targets.h"

namespace lacuna::options {

// Names and values in the order of reports, whichever language writes these.
using Description = std::vector<std::pair<std::string, Value>>;

// The request as far as it decides which points are made, without what lies in files: field, mask,
// kept points, classes and the border around them. `result` has the lines per radius and tells sets
// with a scale from others.
Description describe(const Request& request, const Result& result);

// Where the set was made.
Description describe_place(const Request& request);

}  // namespace lacuna::options
