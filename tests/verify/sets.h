// Point sets whose closest pair and largest gap are known.
#pragma once

#include <lacuna/lacuna.h>
#include <lacuna/verify.h>

#include <optional>
#include <span>
#include <vector>

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

}  // namespace lacuna::verify
