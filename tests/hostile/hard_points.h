// Kept points at places that are hard for samplers.
#pragma once

#include <lacuna/lacuna.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>

#include "hostile/made.h"
#include "hostile/random_parts.h"
#include "judge/judge.h"

namespace lacuna::tests {

// Why points cannot be kept together; empty if they can.
inline std::string fault_of_kept(const Made& made, std::span<const Point> points) {
    Request request = made.request;
    request.keep = points;
    const double size = request.field == nullptr ? *request.radius : *request.scale;
    return judge::Judge(request, points, {}, size).fault();
}

inline double hard_place(Chooser& choose, const Made& made, double side, std::uint32_t pixels,
                         std::uint32_t others) {
    const double border = made.request.places.border;
    const double near = 0.999 * made.request.domain.longer_side() * 0x1p-28;
    switch (choose.below(5)) {
        case 0:
            if (choose.one_in(2)) return 0.0;
            return made.request.domain.wraps() ? std::nextafter(side, 0) : side;
        case 1:
            return choose.one_in(2) ? border : side - border;
        case 2:
        case 3: {
            const std::uint32_t count = std::max(1U, choose.one_in(2) ? pixels : others);
            return side * choose.below(count + 1) / count +
                   std::array{0.0, 0.0, near, -near, near / 8}[choose.below(5)];
        }
        default:
            return choose.in(0, side);
    }
}

// Instead of some of the kept points: at corners, on borders of pixels or close enough to count
// for both pixels, at Places::border, or at exactly the least distance from another one.
inline void add_hard_points(Chooser& choose, Made& made) {
    const Request& request = made.request;
    made.keep.resize(1 + choose.below(static_cast<std::uint32_t>(made.keep.size())));
    for (int tries = 40; tries != 0; --tries) {
        Point at{
            hard_place(choose, made, request.domain.width, made.field.columns, made.mask.columns),
            hard_place(choose, made, request.domain.height, made.field.rows, made.mask.rows)};
        if (choose.one_in(4)) {  // beside another one, as near as it may be
            const Point other =
                made.keep[choose.below(static_cast<std::uint32_t>(made.keep.size()))];
            const double size = request.field == nullptr ? *request.radius : *request.scale;
            const auto shape = judge::Judge(request, {}, {}, size).shape_at(other);
            at = other;
            if (shape) (choose.one_in(2) ? at.x : at.y) += shape->shorter;
        }
        // At the seam of a torus the mask goes on beyond the edges, but polygons do not.
        if (!made.polygons.empty() && judge::depth_in(made.polygons, at) < 0) continue;
        // A border may be smaller than what the judge leaves to rounding, and is kept exactly.
        if (judge::to_edges(request.domain, at) < request.places.border) continue;
        made.keep.push_back(at);
        if (!fault_of_kept(made, made.keep).empty()) made.keep.pop_back();
    }
}

}  // namespace lacuna::tests
