// Point sets whose closest pair and largest gap are known, and slow ways to find both.
#pragma once

#include <lacuna/lacuna.h>
#include <lacuna/verify.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "verify/closest.h"
#include "verify/domain.h"

namespace lacuna::verify {

// n x n points, in the centres of the n x n equal squares that make up the unit square.
inline std::vector<Point> square_lattice(int n) {
    std::vector<Point> points;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) points.push_back({(i + 0.5) / n, (j + 0.5) / n});
    return points;
}

// Rows of points at a distance of 1, `height` apart. Every second row is shifted by 1/2, so that
// the points form equilateral triangles if height = sqrt(3) / 2. The lattice fills a torus of
// columns x (2 * pairs_of_rows * height).
inline std::vector<Point> hexagonal_lattice(int columns, int pairs_of_rows, double height) {
    std::vector<Point> points;
    for (int row = 0; row < 2 * pairs_of_rows; ++row)
        for (int i = 0; i < columns; ++i)
            points.push_back({i + (row % 2 == 0 ? 0.25 : 0.75), (row + 0.5) * height});
    return points;
}

// What prove() says about points of one radius. If no tolerance is given, it is the default.
inline Proof check(std::span<const Point> points, double width, double height, bool torus,
                   double radius, std::optional<double> tolerance = std::nullopt) {
    Claim claim;
    claim.radius = radius;
    claim.domain.width = width;
    claim.domain.height = height;
    claim.domain.boundary = torus ? Boundary::torus : Boundary::box;
    claim.tolerance = tolerance;
    return prove(points, claim);
}

inline double distance_to_nearest(const Domain& domain, std::span<const Point> points, Point at) {
    double least = std::numeric_limits<double>::infinity();
    for (const Point& point : points) least = std::min(least, domain.distance(at, point));
    return least;
}

// Looks at all pairs, from lower to higher indices.
inline Pair closest_of_all_pairs(const Domain& domain, std::span<const Point> points) {
    Pair closest;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = i + 1; j < points.size(); ++j)
            if (const double d = domain.distance(points[i], points[j]); d < closest.distance)
                closest = {i, j, d};
    return closest;
}

// The largest distance to the nearest point, over a raster of (steps + 1)^2 spots that includes
// edges and corners. It is at most the size of the largest gap, and smaller by at most half a
// diagonal of the raster's squares.
inline double farthest_of_raster(const Domain& domain, std::span<const Point> points, int steps) {
    double farthest = 0;
    for (int i = 0; i <= steps; ++i)
        for (int j = 0; j <= steps; ++j)
            farthest = std::max(farthest, distance_to_nearest(domain, points,
                                                              {domain.width * i / steps,
                                                               domain.height * j / steps}));
    return farthest;
}

}  // namespace lacuna::verify
