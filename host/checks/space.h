// What neither a request nor a claim in space may have.
#pragma once

#include <lacuna/space.h>

#include <span>

namespace lacuna {

// Throw BadRequest.
void check_mesh(const Mesh& mesh);
void check_volume(const Volume& volume);
// That the coordinates are finite. `option` names the points.
void check_points(std::span<const Point3> points, const char* option);

}  // namespace lacuna
