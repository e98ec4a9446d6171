// Vectors of doubles, for areas and normals of triangles.
#pragma once

#include <lacuna/space.h>

#include <array>
#include <cmath>

namespace lacuna::space {

inline Point3 operator-(const Point3& a, const Point3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
// Not std::hypot, whose last bit differs between systems.
inline double length_of(const Point3& way) {
    return std::sqrt(way.x * way.x + way.y * way.y + way.z * way.z);
}
// Across the triangle, to the side from which its corners go around counterclockwise; twice as long
// as its area.
inline Point3 across(const std::array<Point3, 3>& corners) {
    const Point3 u = corners[1] - corners[0], v = corners[2] - corners[0];
    return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}
inline double area_of(const std::array<Point3, 3>& corners) {
    return length_of(across(corners)) / 2;
}
inline std::array<Point3, 3> corners_of(const Mesh& mesh, std::size_t triangle) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

}  // namespace lacuna::space
