// How much paper dots cover.
#pragma once

#include <lacuna/lacuna.h>

#include <span>

namespace lacuna::drawing {

// The area of the domain that dots cover together, each `times` as wide as its ellipse. It is
// counted on a raster of some 64 positions a dot, 2^16 to 2^22 in all.
double covered_area(std::span<const Point> points, std::span<const Ellipse> dots, double times,
                    const Domain& domain);

}  // namespace lacuna::drawing
