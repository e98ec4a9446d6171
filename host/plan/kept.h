// The points that are there already, which a request keeps.
#pragma once

#include <lacuna/lacuna.h>

#include <cstddef>

namespace lacuna {

// That a point lies in the domain, where samples may. One within 2^-28 of the longer side of the
// border of two pixels may count for either, for so far off may a set be that was made in whole
// units. Throws BadRequest that names it.
void check_kept_place(const Request& request, std::size_t index);

// That no two kept points are closer than their limit, the smaller of their radii; for a request
// that was checked, and has a radius or a scale. Throws BadRequest that names both.
void check_kept_distances(const Request& request);

}  // namespace lacuna
