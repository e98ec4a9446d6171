// A periodogram's sums by a non-uniform fast Fourier transform: for sets with many points.
#pragma once

#include <lacuna/lacuna.h>

#include <span>
#include <vector>

#include "analysis/domain.h"
#include "analysis/spectrum.h"

namespace lacuna::analysis {

// The same result as periodogram(), in time that grows with the number of frequencies plus the
// number of points, not with their product. Uses all cores; the result does not depend on their
// number. Memory: 40 bytes for each frequency of half the plane, 16 bytes a point, and 256 bytes a
// thread for each of the about 4 kx_max columns of the grid. Throws Cancelled.
std::vector<double> fast_periodogram(std::span<const Point> points, const Domain& domain,
                                     Range range, const KeepGoing& keep_going);

}  // namespace lacuna::analysis
