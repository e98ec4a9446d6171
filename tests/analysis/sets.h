// Point sets whose spectrum and distances are known.
#pragma once

#include <lacuna/lacuna.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "analysis/domain.h"

namespace lacuna::analysis {

using Random = std::mt19937_64;
using Sets = std::vector<std::vector<Point>>;

inline bool carry_on(double) {
    return true;
}

// A number in [0, 1) of 53 bits; unlike std's distributions it is the same everywhere.
inline double uniform(Random& random) {
    return static_cast<double>(random() >> 11U) * 0x1p-53;
}

inline std::vector<Point> white_noise(std::size_t count, const Domain& domain, std::uint64_t seed) {
    Random random(seed);
    std::vector<Point> points(count);
    for (Point& point : points)
        point = {domain.width * uniform(random), domain.height * uniform(random)};
    return points;
}

// columns x rows points in the middles of the cells of a grid, moved within them by up to `jitter`
// of a cell.
inline std::vector<Point> grid(int columns, int rows, const Domain& domain, double jitter = 0,
                               std::uint64_t seed = 0) {
    Random random(seed);
    std::vector<Point> points;
    for (int i = 0; i < columns; ++i)
        for (int j = 0; j < rows; ++j) {
            const double x = i + 0.5 + jitter * (uniform(random) - 0.5);
            const double y = j + 0.5 + jitter * (uniform(random) - 0.5);
            points.push_back({domain.width * x / columns, domain.height * y / rows});
        }
    return points;
}

// Equilateral triangles of side 1 on the torus columns x sqrt(3) pairs_of_rows.
inline Domain hexagonal_domain(int columns, int pairs_of_rows) {
    return {double(columns), std::sqrt(3.0) * pairs_of_rows, true};
}
inline std::vector<Point> hexagonal(int columns, int pairs_of_rows) {
    std::vector<Point> points;
    for (int row = 0; row < 2 * pairs_of_rows; ++row)
        for (int i = 0; i < columns; ++i)
            points.push_back({i + (row % 2 == 0 ? 0.25 : 0.75), (row + 0.5) * std::sqrt(3.0) / 2});
    return points;
}

}  // namespace lacuna::analysis
