// Maximal sets of points in space, on the surface of a triangle mesh or in a box, and their proofs.
// Link lacuna.
//
//     const lacuna::SpaceResult set = lacuna::sample_surface({.mesh = &bunny, .radius = 0.01});
//     lacuna::prove(set.points, {.mesh = &bunny, .radius = 0.01}).maximal;  // or as others made
//     them
//
// What is promised
//   - No two points are closer than the radius, computed in double from the points returned.
//     Distances are straight through space: two points on both sides of a thin wall conflict.
//   - Every spot of the surface, or of the volume, has a point within the radius plus 2^-28 of the
//     longest side of the box around it, with kept points 2^-27. Points lie on the surface, to
//     within 2^-29 of that side.
//   - The set is distributed as if darts were thrown, evenly by area or volume, until no room is
//     left. On a surface that is flat compared with the radius there are about 0.697 * area /
//     radius^2 points; in a volume on a torus 0.734 * volume / radius^3.
//   - The same request and seed give the same points, bit for bit, on every backend and with any
//     number of threads.
//   - Points come in the order in which they were admitted, after those that were kept.
#pragma once

#include <lacuna/domain.h>
#include <lacuna/export.h>
#include <lacuna/run.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace LACUNA_API lacuna {

struct Point3 {
    double x = 0;
    double y = 0;
    double z = 0;
    friend bool operator==(const Point3&, const Point3&) = default;
};

// A surface of triangles, whose corners are numbers of vertices. Triangles without area, vertices
// that are used twice or never, holes, edges of three triangles and triangles that cross each other
// are as good as any: the surface is what lies on some triangle.
struct Mesh {
    std::vector<Point3> vertices{};
    std::vector<std::array<std::uint32_t, 3>> triangles{};
};

// A box with its lower corner at (0, 0, 0), or a torus, whose opposite sides are the same.
struct Volume {
    double width = 1;
    double height = 1;
    double depth = 1;
    Boundary boundary = Boundary::box;
};

// What sample_surface() and sample_volume() are to make. Exactly one of radius and count must be
// given.
struct SpaceRequest {
    const Mesh* mesh = nullptr;  // of sample_surface; must outlive the call
    Volume volume{};             // of sample_volume
    // Least distance between two points: at least 2^-20 of the longest side of the volume, or of
    // the box around the mesh; on a torus at most the shortest side.
    std::optional<double> radius{};
    // Exactly this many points, at a radius that has room for a few more: the set is not maximal.
    // Not on a mesh without area.
    std::optional<std::uint64_t> count{};
    // On a mesh: whether points may lie on each triangle; 0: not. Empty: on all.
    std::span<const std::uint8_t> allowed{};
    // Points that are there already. They come first in the result, bit for bit, and count. They
    // must lie in the volume or in the box around the surface, and keep the radius, to within 2^-29
    // of its longest side. A set with points beside the surface is refuted by prove().
    std::span<const Point3> keep{};
    std::optional<std::uint64_t> limit{};  // stop after this many points, >= 1
    std::uint64_t seed = 0;                // sets of different seeds are independent
    std::uint64_t round_size = 0;          // draws in a round; 0: automatic
    RunOn run_on = RunOn();
};

struct SpaceResult {
    std::vector<Point3> points{};
    // On a mesh, of each point that was not kept: the number of its triangle, and its barycentric
    // coordinates, the shares of the three corners.
    std::vector<std::uint32_t> triangles{};
    std::vector<std::array<double, 3>> shares{};
    double radius = 0;     // asked for, or chosen for the count
    bool maximal = false;  // false if limit or count ended the run while there was room
    std::uint64_t rounds = 0;
    std::uint64_t draws = 0;
    std::string backend{};
    std::string device{};
};

// Make the set that `request` describes. Throw BadRequest (also as MemoryRefused), Unavailable,
// Cancelled.
SpaceResult sample_surface(const SpaceRequest& request);
SpaceResult sample_surface(const SpaceRequest& request, Observer& observer);
SpaceResult sample_volume(const SpaceRequest& request);
SpaceResult sample_volume(const SpaceRequest& request, Observer& observer);

// The unit normals of triangles of the mesh, such as SpaceResult::triangles: to the side from which
// their corners go around counterclockwise. (0, 0, 0) for a triangle without area. Throws
// BadRequest for numbers out of range.
std::vector<Point3> normals_of(const Mesh& mesh, std::span<const std::uint32_t> triangles);

// What is to be proven of a set in space: no two points are closer than the radius, and no spot of
// the surface, or without a mesh of the volume, is farther from all points.
struct SpaceClaim {
    const Mesh* mesh = nullptr;  // must outlive the call
    Volume volume{};             // without a mesh
    double radius = 0;           // > 0
    // How far points may lie from the surface, and how far over the radius a gap may be. If unset,
    // it is 2^-28 of the longest side of the volume or of the box around the mesh.
    std::optional<double> tolerance{};
    bool distances_only = false;  // gaps are not looked for, which takes most of the time
};

// What was found. Points are numbered from 0, in the order given.
struct SpaceProof {
    // The first point that lies off the surface, or outside of the volume. If there is one, nothing
    // else was looked at.
    std::optional<std::size_t> outside{};
    // The closest pair.
    bool kept = false;
    std::size_t first = 0;
    std::size_t second = 0;
    double least_distance = 0;  // infinite for fewer than two points
    // The largest gap: the spot that is farthest from every point. No spot is farther than it by
    // more than half of the tolerance, or than a thousandth of what its distance and the radius
    // differ by.
    bool covered = false;
    Point3 largest_gap{};
    double largest_gap_distance = 0;  // infinite without points
    double tolerance = 0;             // as claimed, or chosen
    // The set is kept and covered, and the tolerance is at most 1 % of the radius.
    bool maximal = false;
};

// Proves or refutes the claim in doubles, from the coordinates alone. A part of a triangle or of
// the volume is covered by a point if its corners are, as both are convex; other parts are split.
// The time grows with the number of points and of triangles, and is that of one thread.
// `keep_going`, if given, is asked often; if it returns false the work ends. Throws BadRequest for
// a mesh whose numbers are out of range, that has a coordinate which is not finite, or no triangle;
// for a volume, radius or tolerance that makes no sense; and for points that are not finite. Throws
// Cancelled.
SpaceProof prove(std::span<const Point3> points, const SpaceClaim& claim,
                 const std::function<bool()>& keep_going = {});

}  // namespace lacuna
