// Marks the positions of a raster that dots and strokes cover.
#include "stipple/coverage.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"
#include "base/polling.h"
#include "plan/ellipse.h"

namespace lacuna::stippling {

Raster::Raster(const Domain& domain, double positions) : domain_(domain) {
    const double step = std::sqrt(domain.width * domain.height / positions);
    columns_ = std::max(1.0, std::round(domain.width / step));
    rows_ = std::max(1.0, std::round(domain.height / step));
    covered_.resize(columns() * rows());
}

void Raster::clear() {
    std::fill(covered_.begin(), covered_.end(), std::uint8_t{0});
}

// Covers the x between the two numbers of chord(y), for y from -reach to reach, from the middle.
template <typename Chord>
void Raster::cover(Point middle, double reach, Chord chord) {
    const Point at = domain_.from_corner(middle);
    const double per_x = columns_ / domain_.width, per_y = rows_ / domain_.height;
    const double end = std::floor((at.y + reach) * per_y + 0.5);
    // Positions are the middles of cells.
    for (double row = std::ceil((at.y - reach) * per_y - 0.5); row < end; ++row) {
        const auto [left, right] = chord((row + 0.5) / per_y - at.y);
        const double first = std::ceil((at.x + left) * per_x - 0.5);
        const double last = std::floor((at.x + right) * per_x + 0.5);
        for (double column = first; column < last; ++column) put(column, row);
        ask_after(static_cast<std::size_t>(std::max(1.0, last - first)));
    }
}

void Raster::cover_ellipse(Point middle, const Ellipse& dot) {
    const double square = 1 / (dot.a * dot.a);
    const QuadraticForm form = dot.a == dot.b ? QuadraticForm{square, 0, square} : form_of(dot);
    // How far the ellipse reaches up; a row at y has the x between the two roots.
    const double reach = std::sqrt(form.xx) * dot.a * dot.b;
    const double lean = -form.xy / form.xx, half = 1 / std::sqrt(form.xx);
    cover(middle, reach, [&](double y) {
        const double way = half * std::sqrt(std::max(0.0, 1 - y / reach * (y / reach)));
        return std::pair(lean * y - way, lean * y + way);
    });
}

// The line is a disk whose middle moves from one end to the other. In a row the disk is furthest to
// the left where its rim, at the row, is the line's left edge.
void Raster::cover_stroke(Point middle, const Ellipse& stroke) {
    const Direction way = direction_of(stroke.angle);
    const double r = stroke.b, half = std::max(0.0, stroke.a - r), up = way.y < 0 ? -1 : 1;
    const double end_x = up * half * way.x, end_y = up * half * way.y;
    const auto edge = [&](double row, double side) {
        double t = end_x * side > 0 ? 1 : -1;
        if (end_y > 0) {
            const double at_rim = (row + side * up * r * way.x) / end_y;
            t = std::clamp(at_rim, std::max(-1.0, (row - r) / end_y),
                           std::min(1.0, (row + r) / end_y));
        }
        const double dy = row - t * end_y;
        return t * end_x + side * std::sqrt(std::max(0.0, r * r - dy * dy));
    };
    cover(middle, end_y + r, [&](double row) { return std::pair(edge(row, -1), edge(row, 1)); });
}

void Raster::put(double column, double row) {
    if (domain_.wraps()) {
        column -= columns_ * std::floor(column / columns_);
        row -= rows_ * std::floor(row / rows_);
    }
    if (column >= 0 && column < columns_ && row >= 0 && row < rows_)
        covered_[static_cast<std::size_t>(row * columns_ + column)] = 1;
}

double covered_area(std::span<const Point> points, std::span<const Ellipse> dots, double times,
                    const Domain& domain) {
    constexpr double kLeast = 1 << 16, kMost = 1 << 18, kForADot = 16;
    Raster raster(domain, std::clamp(kForADot * static_cast<double>(points.size()), kLeast, kMost));
    for (std::size_t i = 0; i < points.size(); ++i)
        raster.cover_ellipse(points[i], {times * dots[i].a, times * dots[i].b, dots[i].angle});
    const std::span<const std::uint8_t> covered = raster.covered();
    const auto count = std::count(covered.begin(), covered.end(), std::uint8_t{1});
    return static_cast<double>(count) / static_cast<double>(covered.size()) * domain.width *
           domain.height;
}

}  // namespace lacuna::stippling
