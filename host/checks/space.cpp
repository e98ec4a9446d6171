// Checks meshes, volumes and points in space.
#include "checks/space.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "base/number_text.h"
#include "base/polling.h"

namespace lacuna {
namespace {

bool is_finite(const Point3& point) {
    return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

}  // namespace

void check_mesh(const Mesh& mesh) {
    if (mesh.triangles.empty())
        throw BadRequest("mesh", "without triangles", "must have one at least");
    for_each_polled(mesh.vertices.size(), ask, [&](std::size_t i) {
        if (!is_finite(mesh.vertices[i]))
            throw BadRequest("mesh", "vertex " + std::to_string(i), "must have finite coordinates");
    });
    for_each_polled(mesh.triangles.size(), ask, [&](std::size_t i) {
        for (const std::uint32_t vertex : mesh.triangles[i])
            if (vertex >= mesh.vertices.size())
                throw BadRequest("mesh", "triangle " + std::to_string(i),
                                 "has vertex " + std::to_string(vertex) + ": must be less than " +
                                     std::to_string(mesh.vertices.size()) +
                                     ", the number of vertices");
    });
}

void check_volume(const Volume& volume) {
    constexpr double kLargestAspect = 1000;
    const auto [shortest_side, longest] = std::minmax({volume.width, volume.height, volume.depth});
    const std::string text =
        shortest(volume.width) + "x" + shortest(volume.height) + "x" + shortest(volume.depth);
    for (const double side : {volume.width, volume.height, volume.depth})
        if (!(side >= 1e-100 && side <= 1e100))
            throw BadRequest("domain", text, "the sides must lie between 1e-100 and 1e100");
    if (longest > kLargestAspect * shortest_side)
        throw BadRequest(
            "domain", text,
            "the longest side may be at most " + shortest(kLargestAspect) + " times the shortest");
}

void check_points(std::span<const Point3> points, const char* option) {
    for_each_polled(points.size(), ask, [&](std::size_t i) {
        if (!is_finite(points[i]))
            throw BadRequest(option, "point " + std::to_string(i), "must have finite coordinates");
    });
}

}  // namespace lacuna
