// Draws polygons onto the tree of a mask.
#pragma once

#include <lacuna/places.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "plan/mask_tree.h"

namespace lacuna::places {

struct Canvas {
    Domain domain;
    std::uint32_t columns;  // of the mask
    std::uint32_t rows;
};

// A pixel is allowed if all of it lies where samples may lie, by the sets' edges as they are given.
// Borders of pixels may be off by 2^-27 of the longer side: samplers round them to a grid. Empty if
// there would be more than `most_nodes`. The time is in proportion to the number of edges, and of
// the pixels along edges or at their distance.
std::optional<MaskTree> draw_tree(std::span<const PolygonSet> sets, const Canvas& canvas,
                                  std::size_t most_nodes);

// Whether samples may lie at a position, computed in double from all edges. If it `may_touch`, they
// may lie on edges and at distances, too, as far as coordinates in double can say that they do.
bool allow(std::span<const PolygonSet> sets, Point at, bool may_touch = false);

}  // namespace lacuna::places
