// A rectangle of the domain, and distances from a point to its spots.
#pragma once

#include <lacuna/lacuna.h>

#include <algorithm>
#include <cmath>

namespace lacuna::verify {

// A rectangle with its edges. The two halves of a cell have the same double where they meet, so
// there is no gap between them.
struct Cell {
    double left;
    double right;
    double bottom;
    double top;
};

inline double square(double a) {
    return a * a;
}

// A cell seen from its centre.
struct Frame {
    Point centre;
    double half_width;
    double half_height;

    explicit Frame(const Cell& cell)
        : centre{cell.left + (cell.right - cell.left) / 2,
                 cell.bottom + (cell.top - cell.bottom) / 2},
          half_width((cell.right - cell.left) / 2),
          half_height((cell.top - cell.bottom) / 2) {}

    // Squared distances from a point to the cell's farthest and nearest spots.
    double to_farthest(Point p) const {
        return square(std::abs(p.x - centre.x) + half_width) +
               square(std::abs(p.y - centre.y) + half_height);
    }
    double to_nearest(Point p) const {
        return square(std::max(std::abs(p.x - centre.x) - half_width, 0.0)) +
               square(std::max(std::abs(p.y - centre.y) - half_height, 0.0));
    }
};

}  // namespace lacuna::verify
