// Mode stratified: as many points as asked for, in proportion to the importance. Relaxing begins
// with them.
#pragma once

#include <lacuna/lacuna.h>

#include <cstddef>
#include <cstdint>

#include "base/polling.h"

namespace lacuna {

// Is told what the curve passes: pixels count row by row from the lowest.
class OnCurve {
public:
    virtual ~OnCurve() = default;
    // Before the first cell. Cells are pixels, or the equal parts that all pixels are cut into.
    virtual void begin(std::uint64_t cells_a_pixel) = 0;
    // A point on a pixel, after the mass of this many of its cells.
    virtual void put(std::size_t pixel, double cells) = 0;
    // The curve has passed this many cells of a pixel.
    virtual void leave(std::size_t pixel, double cells) = 0;
};

// Request::count points: the cdf of the importance along a Hilbert curve of the domain is cut into
// `count` equal intervals, and inverted at a random number in the middle half of each. So each
// stretch of the curve has its share of the points, to within one. The curve lies at a random
// place, and the first interval begins at a random place of it, so that no part of the domain has a
// better chance of points than another. They come in the order of the curve. The request must have
// been checked.
std::vector<Point> stratified_points(const Request& request, const Poll& poll,
                                     OnCurve* listener = nullptr);

}  // namespace lacuna
