// The stratified start of relax: as many points as asked for, in proportion to the importance.
#pragma once

#include <lacuna/lacuna.h>

#include "base/polling.h"

namespace lacuna::relaxing {

// Request::count points: the cdf of the importance along a Hilbert curve of the domain, inverted at
// one random number in the middle half of each of `count` equal intervals. So each stretch of the
// curve has its share of the points, to within one. They come in the order of the curve. The
// request must have been checked.
std::vector<Point> stratified_points(const Request& request, const Poll& poll);

}  // namespace lacuna::relaxing
