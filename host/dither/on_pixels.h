// Mode pixels: samples on pixels, at most one on each, and exactly as many as asked for.
#pragma once

#include <lacuna/lacuna.h>

#include <vector>

#include "base/polling.h"

namespace lacuna {

// Request::count points in the centres of pixels of Request::on_pixels, row by row from the top.
// The request must have been checked. Throws BadRequest if there are fewer pixels where samples may
// lie.
std::vector<Point> points_on_pixels(const Request& request, const Poll& poll);

}  // namespace lacuna
