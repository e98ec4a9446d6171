// The domain of a point set under proof, and distances in it as a user would compute them.
#pragma once

#include <lacuna/lacuna.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lacuna::verify {

struct Domain {
    double width;
    double height;
    bool torus;

    double longer_side() const { return std::max(width, height); }

    // More than all roundings together of a distance that is reckoned in doubles, from sums of
    // coordinates under twice the longer side, and compared with another a hundred times.
    double rounding() const { return longer_side() * 0x1p-44; }

    // A box has its far edges, which programs that write float32 round up to; on a torus they are
    // the near ones, and no point should stand for them.
    bool contains(Point p) const {
        const bool is_inside = p.x >= 0 && p.x <= width && p.y >= 0 && p.y <= height;
        return is_inside && (!torus || (p.x < width && p.y < height));
    }

    double distance(Point a, Point b) const {
        const double dx = along(a.x, b.x, width);
        const double dy = along(a.y, b.y, height);
        return std::sqrt(dx * dx + dy * dy);
    }

    // A place along a side and those `blur` before and behind it, around a torus' edges.
    std::array<double, 3> around(double at, double blur, double side) const {
        double before = at - blur;
        double behind = at + blur;
        if (torus && before < 0) before += side;
        if (torus && behind >= side) behind -= side;
        return {before, at, behind};
    }

private:
    double along(double a, double b, double side) const {
        const double straight = std::abs(a - b);
        return torus ? std::min(straight, side - straight) : straight;
    }
};

}  // namespace lacuna::verify
