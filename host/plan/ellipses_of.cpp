// Finds the ellipse of each point, to draw it.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "base/polling.h"
#include "plan/ellipse.h"
#include "plan/pixels_at.h"

namespace lacuna {

std::vector<Ellipse> ellipses_of(std::span<const Point> points, const Field& field, double scale,
                                 const Domain& domain) {
    std::vector<Ellipse> ellipses;
    if (field.stretches.empty()) return ellipses;
    ellipses.reserve(points.size());
    for_each_polled(points.size(), ask, [&](std::size_t i) {
        const Point& point = points[i];
        std::size_t found = 0;
        double greatest = -1;
        for_pixels_at(point, domain, field.columns, field.rows, [&](std::size_t pixel) {
            if (field.importance[pixel] <= greatest) return;
            greatest = field.importance[pixel];
            found = pixel;
        });
        ellipses.push_back(stretched(scale / std::sqrt(greatest), field.stretches[found]));
    });
    return ellipses;
}

}  // namespace lacuna
