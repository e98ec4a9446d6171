// Makes strokes, cuts them at the picture's edges, and turns them.
#include "stipple/strokes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "base/angle.h"

namespace lacuna::stippling {

void make_strokes(std::span<Ellipse> ellipses, double ink, double pen) {
    double roots = 0;
    for (const Ellipse& one : ellipses) roots += std::sqrt(one.a / one.b);
    // A stroke has round ends: of its length times the width they lack 1 - pi / 4 squares.
    const double lacking = static_cast<double>(ellipses.size()) * pen * (1 - std::numbers::pi / 4);
    const double length = (ink / pen + lacking) / roots;
    for (Ellipse& one : ellipses)
        one = {std::max(pen, length * std::sqrt(one.a / one.b)) / 2, pen / 2, one.angle};
}

bool cut_strokes(std::span<Point> middles, std::span<Ellipse> strokes, const Domain& domain) {
    bool are_cut = false;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        const double half = strokes[i].a - strokes[i].b;
        const Direction along = direction_of(strokes[i].angle);
        const Point at = domain.from_corner(middles[i]);
        // How far it is from the middle to the stroke's end, or to an edge before it.
        const auto reach = [&](double x, double y) {
            const auto to_edge = [&](double from, double side, double step) {
                return step == 0 ? half : (step > 0 ? side - from : -from) / step;
            };
            return std::max(0.0, std::min({half, to_edge(at.x, domain.width, x),
                                           to_edge(at.y, domain.height, y)}));
        };
        const double ahead = reach(along.x, along.y), behind = reach(-along.x, -along.y);
        if (ahead == half && behind == half) continue;
        middles[i].x += (ahead - behind) / 2 * along.x;
        middles[i].y += (ahead - behind) / 2 * along.y;
        strokes[i].a = strokes[i].b + (ahead + behind) / 2;
        are_cut = true;
    }
    return are_cut;
}

void turn_strokes(std::span<const Point> middles, std::span<Ellipse> strokes) {
    Point from = middles.empty() ? Point{} : middles.front();
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        const auto squared_way_to = [&](double sign) {
            const Point end = end_of(middles[i], strokes[i], sign);
            return (end.x - from.x) * (end.x - from.x) + (end.y - from.y) * (end.y - from.y);
        };
        if (squared_way_to(1) < squared_way_to(-1)) strokes[i].angle += std::numbers::pi;
        from = end_of(middles[i], strokes[i], 1);
    }
}

Point end_of(Point middle, const Ellipse& stroke, double sign) {
    const Direction along = direction_of(stroke.angle);
    const double half = sign * (stroke.a - stroke.b);
    return {middle.x + half * along.x, middle.y + half * along.y};
}

}  // namespace lacuna::stippling
