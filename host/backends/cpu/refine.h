// refine: cuts active boxes by all samples near them (docs/design.md, section 4, "exact").
#pragma once

#include <span>
#include <vector>

#include "backends/cpu/neighbour_lists.h"
#include "backends/cpu/sample_grid.h"

namespace lacuna::cpu {

// Appends to `left` the pieces of boxes that the samples near them leave. With `halve` each box is
// halved first: along x or, where it lies on unlike pixels, along borders of pixels. The boxes are
// those of a column, in their order.
void refine(const SampleGrid& grid, std::span<const Box> boxes, bool halve, std::vector<Box>& left);
void refine(NeighbourLists& lists, std::span<const BlockBox> boxes, bool halve,
            std::vector<BlockBox>& left);

}  // namespace lacuna::cpu
