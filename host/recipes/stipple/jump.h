// Lets dots of a frame jump to where the next picture needs them.
#pragma once

#include <lacuna/lacuna.h>

#include <span>
#include <vector>

namespace lacuna::recipes {

// The dots, of which some have jumped: from blocks of about nine dots that have clearly more dots
// than `fair` ones, to blocks that have clearly fewer, onto fair dots there. `fair` are as many
// dots that were placed anew. Relaxing moves a dot by a few spacings at most, so a shape that goes
// faster would lose its dots. In a still picture hardly a dot jumps.
std::vector<Point> jumped(std::span<const Point> dots, std::span<const Point> fair,
                          const Domain& domain);

}  // namespace lacuna::recipes
