// The two points of a set that are closest to each other.
#pragma once

#include <lacuna/lacuna.h>

#include <cstddef>
#include <limits>
#include <span>

#include "verify/domain.h"
#include "verify/patience.h"

namespace lacuna::verify {

struct Pair {
    std::size_t first = 0;  // less than `second`
    std::size_t second = 0;
    double distance = std::numeric_limits<double>::infinity();  // so for fewer than two points
};

// All points must lie in the domain. Of several closest pairs, the one of lowest indices, but for
// points that coincide. Never compares all pairs, however the points are crowded.
Pair closest_pair(const Domain& domain, std::span<const Point> points,
                  const Patience& patience = {});

}  // namespace lacuna::verify
