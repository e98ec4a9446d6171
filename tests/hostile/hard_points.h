// Kept points at places that are hard for samplers.
#pragma once

#include <lacuna/lacuna.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "hostile/made.h"
#include "hostile/random_parts.h"

namespace lacuna::tests {

// The least radius of all pixels within 2^-28 of the longer side, where the point may lie.
inline std::optional<double> radius_of_kept(const Made& made, Point at) {
    const Request& request = made.request;
    const verify::Domain domain = made.domain();
    const double border = request.border;
    if (!(domain.contains(at) && at.x >= border && domain.width - at.x >= border &&
          at.y >= border && domain.height - at.y >= border))
        return std::nullopt;
    const verify::FieldCase pixels{.name = "", .field = {}, .domain = domain};
    const double blur = domain.longer_side() * 0x1p-28;
    std::optional<double> radius;
    bool is_open = false;
    for (const double dx : {-blur, 0.0, blur})
        for (const double dy : {-blur, 0.0, blur}) {
            const Point near{at.x + dx, at.y + dy};
            is_open |=
                request.mask == nullptr ||
                made.mask.allowed[pixels.pixel_of(near, made.mask.columns, made.mask.rows)] != 0;
            const double importance =
                request.field == nullptr
                    ? 1
                    : made.field
                          .importance[pixels.pixel_of(near, made.field.columns, made.field.rows)];
            const double size = request.field == nullptr ? *request.radius : *request.scale;
            if (importance > 0)
                radius = std::min(radius.value_or(std::numeric_limits<double>::infinity()),
                                  size / std::sqrt(importance));
        }
    return is_open ? radius : std::nullopt;
}

inline double hard_place(Chooser& choose, const Made& made, double side, std::uint32_t pixels,
                         std::uint32_t others) {
    const double border = made.request.border;
    const double near = 0.999 * made.domain().longer_side() * 0x1p-28;
    switch (choose.below(5)) {
        case 0:
            if (choose.one_in(2)) return 0.0;
            return made.domain().torus ? std::nextafter(side, 0) : side;
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
// for both pixels, at Request::border, or at exactly the least distance from another one.
inline void add_hard_points(Chooser& choose, Made& made) {
    const Request& request = made.request;
    made.keep.resize(1 + choose.below(static_cast<std::uint32_t>(made.keep.size())));
    for (int tries = 40; tries != 0; --tries) {
        Point at{
            hard_place(choose, made, request.domain.width, made.field.columns, made.mask.columns),
            hard_place(choose, made, request.domain.height, made.field.rows, made.mask.rows)};
        const auto there = radius_of_kept(made, at);
        if (there && choose.one_in(4)) {
            at = made.keep[choose.below(static_cast<std::uint32_t>(made.keep.size()))];
            (choose.one_in(2) ? at.x : at.y) += *radius_of_kept(made, at);
        }
        const auto radius = radius_of_kept(made, at);
        const auto is_far = [&](Point other) {
            return made.domain().distance(at, other) >=
                   std::min(*radius, radius_of_kept(made, other).value_or(0));
        };
        if (radius && std::all_of(made.keep.begin(), made.keep.end(), is_far))
            made.keep.push_back(at);
    }
}

}  // namespace lacuna::tests
