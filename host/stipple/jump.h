// Lets dots of a frame jump to where the next picture needs them.
#pragma once

#include <lacuna/lacuna.h>

#include <span>
#include <vector>

namespace lacuna::stippling {

// The dots of a picture before, some of which have jumped to where this picture needs them. `fair`
// are about as many dots that were placed anew: they show how many each part of the picture needs.
//
// Parts that have clearly more dots than they need give them to parts that have clearly fewer:
// blocks of many sizes, from a part of the picture's width down to a few dots. All dots on pixels
// of importance 0 jump. In a still picture few dots do. Relaxing alone moves a dot by a few
// spacings at most, so a shape that goes faster would lose its dots.
std::vector<Point> jumped(std::span<const Point> dots, std::span<const Point> fair,
                          const Field& field, const Domain& domain);

}  // namespace lacuna::stippling
