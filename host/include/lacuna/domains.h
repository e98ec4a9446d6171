// Where samples may lie, from files: outlines of polygons.
#pragma once

#include <lacuna/lacuna.h>

#include <vector>

namespace lacuna {

// A closed outline: its last point is joined to its first. Several rings together enclose what an
// odd number of them goes around, so that a ring within a ring is a hole.
using Ring = std::vector<Point>;

}  // namespace lacuna
