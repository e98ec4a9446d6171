// A disk's area as it is seen by lines, or by a lattice: what figure 3 measures.
#pragma once

#include <cstdint>

namespace lacuna::reproduce {

// Of a disk of radius m, its centre `offset` (0 to 1) to the right of a line, with lines 1 apart:
// the sum of the chords over the disk's area. This is what mode lines takes from the marginal.
double area_by_lines(std::uint32_t m, double offset);

// The lattice points within the disk, its rim left out, over its area: likewise for mode cells.
double area_by_cells(std::uint32_t m, double offset_x, double offset_y);

}  // namespace lacuna::reproduce
