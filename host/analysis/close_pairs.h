// Counts the pairs of a set by their distance.
#pragma once

#include <lacuna/lacuna.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "analysis/domain.h"
#include "base/polling.h"

namespace lacuna::analysis {

// Entry i, for i below `bins`, is the number of pairs whose distance is in [i, i + 1) * width. On a
// torus each image of a pair counts for itself. The points must lie in the domain, its upper edges
// included, and bins * width must not exceed half the domain's shorter side. Uses all cores and
// polls on the calling thread. Memory: at most 64 bytes a point.
std::vector<std::uint64_t> count_close_pairs(std::span<const Point> points, const Domain& domain,
                                             double width, std::size_t bins, const Poll& poll);

}  // namespace lacuna::analysis
