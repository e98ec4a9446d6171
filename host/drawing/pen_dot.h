// Dots that are wider than the pen that draws them.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lacuna::drawing {

// The way of a pen through a dot: half circles from right to left and back, the first of radius
// `step`, each next one a step larger, and the last as large as the one before it, which closes the
// dot's edge. Those above begin and end left and right of the dot's middle, those below of a middle
// that lies a step further right. So lines that lie beside each other are two steps apart. Without
// half circles the pen dips.
struct PenDot {
    double step = 0;
    int halves = 0;

    double reach() const { return (halves - 1) * step; }  // of the middle of the outermost line
    double length() const {
        const int radii = halves / 2 + 1;  // in lengths of reach(), the sum of all
        return halves == 0 ? 0 : std::numbers::pi * reach() * radii;
    }
    // Where the pen comes down and goes up, to the right of the dot's middle.
    double begin() const { return step; }
    double end() const { return halves == 0 ? 0 : reach(); }

    // Calls visit(middle, radius, is_above) for each half circle: how far its middle is to the
    // right of the dot's.
    template <class Visit>
    void for_each_half(const Visit& visit) const {
        for (int k = 1; k < halves; ++k) visit(k % 2 == 1 ? 0.0 : step, k * step, k % 2 == 1);
        if (halves != 0) visit(0.0, reach(), false);
    }
};

// The way of a pen whose line has the dot's edge as its outer edge: a circle, or a spiral that
// leaves no gap because its lines overlap by a tenth. All in one unit.
inline PenDot pen_dot(double diameter, double pen, bool is_circle) {
    constexpr double kApart = 0.9, kAsWide = 1 + 1e-9, kMostTurns = 1e6;
    if (!(diameter > pen * kAsWide)) return {};
    const double reach = (diameter - pen) / 2;
    const double turns = is_circle ? 1 : std::ceil(reach / (kApart * pen) + 0.5);
    const int steps = 2 * static_cast<int>(std::min(turns, kMostTurns)) - 1;
    return {reach / steps, steps + 1};
}

}  // namespace lacuna::drawing
