// A disk's area as measured by lines, or by a lattice: figure 3 shows both.
#pragma once

#include <cstdint>

namespace lacuna::reproduce {

// The sum of the chords over the disk's area, for a disk of radius m whose centre is `offset` (0 to
// 1) to the right of a line, with lines 1 apart. Mode lines takes this from the marginal.
double area_by_lines(std::uint32_t m, double offset);

// The number of lattice points inside the disk over its area: what mode cells takes.
double area_by_cells(std::uint32_t m, double offset_x, double offset_y);

}  // namespace lacuna::reproduce
