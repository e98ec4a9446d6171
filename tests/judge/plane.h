// Ways, distances, pixels and polygons as a user computes them: in doubles, from coordinates alone.
// tests/judge has no code of the library but the structs of its public headers.
#pragma once

#include <lacuna/domain.h>
#include <lacuna/places.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace lacuna::judge {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The way from one point to another, the shorter one around the edges of a torus.
Point way(const Domain& domain, Point from, Point to);
double distance(const Domain& domain, Point a, Point b);
double distance_to_nearest(const Domain& domain, std::span<const Point> points, Point at);

struct Pair {
    std::size_t first = 0, second = 0;
    double distance = kInfinity;
};
// The two points that are closest to each other, the first ones of several, in a sweep along x.
Pair closest_pair(const Domain& domain, std::span<const Point> points);
// Their distance over that in a hexagonal lattice of as many points.
double relative_distance(const Domain& domain, std::span<const Point> points);
// The same of each prefix of the points, from that of two on.
std::vector<double> relative_distances(const Domain& domain, std::span<const Point> points);

// A point of a torus after a step over its edges; any other point is returned as it is.
Point wrapped(const Domain& domain, Point at);
// Whether the domain has the point; `is_open`: without its upper edges, which a torus never has.
bool contains(const Domain& domain, Point at, bool is_open = false);
double to_edges(const Domain& domain, Point at);

// The pixel of a raster over the domain that has the point, row by row from the top. On the border
// of two pixels it is the right or the upper one.
std::size_t pixel_of(const Domain& domain, std::uint32_t columns, std::uint32_t rows, Point at);

// How far inside of rings a point is, by the even-odd rule over all edges; below 0 it is outside.
double depth_in(std::span<const PolygonRing> rings, Point at);
// How far inside of what sets of polygons allow, with the distances that these ask for.
double depth_in(std::span<const PolygonSet> sets, Point at);

// For messages: all digits.
std::string text_of(Point at);

}  // namespace lacuna::judge
