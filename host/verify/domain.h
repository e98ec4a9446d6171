// The domain of a point set under proof, its samples, and distances as a user would compute them.
#pragma once

#include <lacuna/lacuna.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lacuna::verify {

// A sample and its radius. It covers a spot up to the smaller of its radius and `factor` times the
// spot's radius. With classes the factor is the distance of the sample's class and the class looked
// at, as a share of the least distance; without classes it is 1.
struct Disk {
    Point at;
    double radius;
    double factor = 1;

    double limit_with(double other) const { return std::min(radius, factor * other); }
};

struct Domain {
    double width;
    double height;
    bool torus;
    double x0 = 0;  // the lower left corner
    double y0 = 0;

    double longer_side() const { return std::max(width, height); }

    // An upper bound of the error of a distance that is computed in doubles, from coordinates that
    // are at most twice the longer side. It is over a hundred times the rounding of one sum.
    double rounding() const { return longer_side() * 0x1p-44; }

    // The same for the coordinates as they are given, whose size grows with the corner's distance
    // from 0.
    double rounding_of_given() const {
        return rounding() + (std::abs(x0) + std::abs(y0)) * 0x1p-50;
    }

    // The far edges belong to a box, because programs that write float32 round up to them. On a
    // torus the far edges are the near ones, and points should lie on those.
    bool contains(Point p) const {
        const double right = x0 + width, top = y0 + height;
        const bool is_inside = p.x >= x0 && p.x <= right && p.y >= y0 && p.y <= top;
        return is_inside && (!torus || (p.x < right && p.y < top));
    }

    // A point as gaps, pixels and polygons are searched: the domain's corner is its (0, 0). In the
    // domain no way is longer than the sides. Distances of points are computed from the points as
    // given instead.
    Point from_corner(Point p) const {
        const auto along = [](double at, double low, double side) {
            return at <= low + side ? std::min(at - low, side) : at - low;
        };
        return {along(p.x, x0, width), along(p.y, y0, height)};
    }

    // The distance of two coordinates along a side, around a torus' edges.
    double along(double a, double b, double side) const {
        const double straight = std::abs(a - b);
        return torus ? std::min(straight, side - straight) : straight;
    }

    // The way from one coordinate to another along a side, the shorter one around a torus' edges.
    double way_along(double from, double to, double side) const {
        const double straight = to - from;
        if (!torus || std::abs(straight) <= side - std::abs(straight)) return straight;
        return straight > 0 ? straight - side : straight + side;
    }

    Point way(Point from, Point to) const {
        return {way_along(from.x, to.x, width), way_along(from.y, to.y, height)};
    }

    double distance(Point a, Point b) const {
        const double dx = along(a.x, b.x, width);
        const double dy = along(a.y, b.y, height);
        return std::sqrt(dx * dx + dy * dy);
    }

    // A coordinate along a side, and the two that are `blur` before and behind it, around the edges
    // of a torus.
    std::array<double, 3> around(double at, double blur, double side) const {
        double before = at - blur;
        double behind = at + blur;
        if (torus && before < 0) before += side;
        if (torus && behind >= side) behind -= side;
        return {before, at, behind};
    }
};

inline Domain domain_of(const lacuna::Domain& domain) {
    return {domain.width, domain.height, domain.wraps(), domain.x0, domain.y0};
}

}  // namespace lacuna::verify
