// The sums of a periodogram by a non-uniform fast Fourier transform: for sets of many points.
#pragma once

#include <lacuna/lacuna.h>

#include <span>
#include <vector>

#include "analysis/domain.h"
#include "analysis/spectrum.h"

namespace lacuna::analysis {

// What periodogram() promises, in time that grows with the frequencies and the points and not with
// their product. On all cores; the result does not depend on their number. Memory: 40 bytes a
// frequency of half the plane, 16 bytes a point, and 256 bytes a thread for each of the some
// 4 kx_max columns of the grid. Throws Cancelled.
std::vector<double> fast_periodogram(std::span<const Point> points, const Domain& domain,
                                     Range range, const KeepGoing& keep_going);

}  // namespace lacuna::analysis
