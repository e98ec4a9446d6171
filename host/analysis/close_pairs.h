// Counts of the pairs of a set by their distance.
#pragma once

#include <lacuna/lacuna.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "analysis/domain.h"
#include "base/polling.h"

namespace lacuna::analysis {

// How many pairs are [i, i + 1) * width apart, for each i below `bins`, on a torus by every way
// that is so short. The points must lie in the domain, its upper edges included, and bins * width
// must not be over half the domain's shorter side. On all cores; polls on the calling thread.
// Memory: 64 bytes a point and less.
std::vector<std::uint64_t> count_close_pairs(std::span<const Point> points, const Domain& domain,
                                             double width, std::size_t bins, const Poll& poll);

}  // namespace lacuna::analysis
