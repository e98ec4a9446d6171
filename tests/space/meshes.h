// Meshes for tests of sets in space.
#pragma once

#include <lacuna/space.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace lacuna::tests {

inline double distance_of(const Point3& a, const Point3& b) {
    return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

// A sphere of radius 1 of `sides` times 2 * `sides` quadrangles: triangles at its poles are thin,
// or have no area.
inline Mesh sphere(std::uint32_t sides) {
    Mesh mesh;
    const double pi = std::acos(-1.0);
    for (std::uint32_t i = 0; i <= sides; ++i)
        for (std::uint32_t j = 0; j < 2 * sides; ++j) {
            const double up = pi * i / sides, around = pi * j / sides;
            mesh.vertices.push_back(
                {std::sin(up) * std::cos(around), std::sin(up) * std::sin(around), std::cos(up)});
            const std::uint32_t row = i * 2 * sides, next = (j + 1) % (2 * sides);
            if (i == sides) continue;
            mesh.triangles.push_back({row + j, row + 2 * sides + j, row + next});
            mesh.triangles.push_back({row + next, row + 2 * sides + j, row + 2 * sides + next});
        }
    return mesh;
}

// Triangles that have nothing to do with each other: some cross, some are long and thin or have no
// area, and some are there twice.
inline Mesh soup(std::uint32_t triangles, std::uint32_t seed) {
    Mesh mesh;
    std::mt19937 random(seed);
    const auto number = [&] { return static_cast<double>(random()) * 0x1p-32; };
    for (std::uint32_t i = 0; i < triangles; ++i) {
        const Point3 a{number(), number(), number()};
        const double size = std::pow(10, -3 * number());
        const auto beside = [&](double share) {
            return Point3{a.x + size * share * (number() - 0.5),
                          a.y + size * share * (number() - 0.5),
                          a.z + size * share * (number() - 0.5)};
        };
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(),
                             {a, beside(1), random() % 4 == 0 ? beside(1e-3) : beside(1)});
        mesh.triangles.push_back({first, first + 1, random() % 8 == 0 ? first : first + 2});
        if (random() % 8 == 0) mesh.triangles.push_back(mesh.triangles.back());
    }
    return mesh;
}

inline double area_of(const Mesh& mesh, std::uint32_t triangle) {
    const auto& [i, j, k] = mesh.triangles[triangle];
    const Point3 &a = mesh.vertices[i], &b = mesh.vertices[j], &c = mesh.vertices[k];
    const double ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z;
    const double vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
    return std::hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx) / 2;
}

inline double area_of(const Mesh& mesh) {
    double area = 0;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) area += area_of(mesh, i);
    return area;
}

}  // namespace lacuna::tests
