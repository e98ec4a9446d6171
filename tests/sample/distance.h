// The distance of two points, as a user would compute it.
#pragma once

#include <lacuna/domain.h>

#include <algorithm>
#include <cmath>

namespace lacuna::tests {

inline double distance_on(const Domain& domain, Point a, Point b) {
    double dx = std::abs(a.x - b.x);
    double dy = std::abs(a.y - b.y);
    if (domain.wraps()) {
        dx = std::min(dx, domain.width - dx);
        dy = std::min(dy, domain.height - dy);
    }
    return std::hypot(dx, dy);
}

}  // namespace lacuna::tests
