// The tiles that a search for the largest gap is made of.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "verify/cell.h"

namespace lacuna::verify {

// How the work is shared out. These numbers decide which of several nearly equal gaps is named.
struct Tiling {
    int along_longer_side;   // number of tiles along the longer side of the bounds
    bool ends_exactly;       // the last tile ends on the bounds, or up to a rounding beside them
    std::size_t scout_step;  // one tile in this many is searched first, and its gap spares the
                             // other tiles most of their work
    int cuts_for_threads;    // how often a tile may be cut in two parts for two threads
};
// A set of one radius has about as many samples in one tile as in another. The end of its last tile
// matters only to sharpened(), which looks up to the bounds.
inline constexpr Tiling kTilingOfOneRadius{16, false, 16, 0};
// A set on a radius field may have most of its samples in one tile.
inline constexpr Tiling kTilingOfField{4, true, 4, 12};

std::vector<Cell> tiles_within(const Cell& bounds, const Tiling& tiling);

// The rectangle around some tiles, at least one.
Cell hull_of(std::span<const Cell> tiles);

}  // namespace lacuna::verify
