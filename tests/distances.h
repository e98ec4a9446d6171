// Distances of point sets as a user would compute them: in double, from the points alone.
#pragma once

#include <lacuna/lacuna.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace lacuna::tests {

inline double axis_distance(double a, double b, double side, bool torus) {
    const double straight = std::abs(a - b);
    return torus ? std::min(straight, side - straight) : straight;
}

// The least distance of any two points, over all pairs in a sweep along x.
inline double least_distance(std::vector<Point> points, double width, double height, bool torus) {
    std::sort(points.begin(), points.end(), [](Point a, Point b) { return a.x < b.x; });
    const std::size_t n = points.size();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t step = 1; step < n; ++step) {
            const std::size_t j = i + step;
            if (j >= n && !torus) break;
            const double ahead =
                j < n ? points[j].x - points[i].x : points[j - n].x + width - points[i].x;
            if (ahead >= least) break;
            const Point other = points[j % n];
            const double dx = axis_distance(points[i].x, other.x, width, torus);
            const double dy = axis_distance(points[i].y, other.y, height, torus);
            least = std::min(least, std::sqrt(dx * dx + dy * dy));
        }
    }
    return least;
}

}  // namespace lacuna::tests
