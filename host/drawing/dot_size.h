// How large the dots of a stippled picture are to be.
#pragma once

#include <lacuna/lacuna.h>

#include <span>
#include <vector>

namespace lacuna::drawing {

// How dots lie: as darts thrown at random do, or relaxed.
enum class Spread { random, even };

// The diameter of each point's dot, in the domain's units, such that the ink covers the share of
// the paper that the importance says: 1 where it is 1 (99 %), a half where it is 0.5. The areas of
// all dots sum to the integral of the importance as long as few overlap; where a local radius is so
// small that more do, importance over 0.55, dots are up to 1.3 times as wide to make up for it;
// where they lie evenly, up to 1.12 times. `points` fill width x height, over which `field` is
// stretched.
std::vector<double> dot_diameters(std::span<const Point> points, const Field& field, double width,
                                  double height, Spread spread = Spread::random);

}  // namespace lacuna::drawing
