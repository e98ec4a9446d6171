// Files of sets in space.
#pragma once

#include <lacuna/space.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "files/formats.h"
#include "files/point_files.h"

namespace lacuna::files {

// A set on a mesh or in a volume. It refers to what it was made of.
struct SetInSpace {
    std::span<const Point3> points{};
    double radius = 0;
    const Origin* origin = nullptr;
    // Exactly one of these two is set.
    const Mesh* mesh = nullptr;
    const Volume* volume = nullptr;
    // On a mesh, of each point that was not kept: the number of its triangle, and its normal.
    std::span<const std::uint32_t> triangles{};
    std::span<const Point3> normals{};

    std::size_t kept() const { return points.size() - triangles.size(); }
};

// Throws BadRequest("output", PATH, ...) if the format has no place for three coordinates.
void check_in_space(const Format& format, const std::string& path);

// The bytes of a file in the given format, which is no picture: drawing/space.h has those.
//   txt, npy  x, y and z alone
//   csv, ply  on a mesh nx, ny and nz, too, the normal, and triangle, a number from 0; for points
//             that were kept they are 0, 0, 0 and -1
//   json      the same as "normals" and "triangles" before "points", and the members of Origin; of
//             a volume width, height, depth and boundary
// Throws what check_in_space() throws.
std::string encode(const SetInSpace& set, const Format& format);

}  // namespace lacuna::files
