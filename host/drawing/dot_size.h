// The sizes of the dots of a stippled picture.
#pragma once

#include <lacuna/lacuna.h>

#include <span>
#include <vector>

namespace lacuna::drawing {

// How dots are spread: like darts thrown at random, or evenly, as relax leaves them.
enum class Spread { random, even };

// The diameter of each point's dot, in the domain's units. The ink then covers the fraction of the
// paper that the importance says: half where it is 0.5, and 99 % where it is 1. As long as few dots
// overlap, the areas of all dots sum to the integral of the importance. Above importance 0.55 more
// dots overlap, so they are up to 1.3 times as wide (1.12 times for Spread::even). `points` fill
// width x height, and `field` is stretched over it.
std::vector<double> dot_diameters(std::span<const Point> points, const Field& field, double width,
                                  double height, Spread spread = Spread::random);

}  // namespace lacuna::drawing
