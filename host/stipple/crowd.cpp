// Keeps dots in a grid whose cells are as wide as the largest distance that matters.
#include "stipple/crowd.h"

#include <algorithm>
#include <cmath>

namespace lacuna::stippling {
namespace {

// The number of cells along a side, each at least `least` long.
std::int64_t cells_along(double side, double least) {
    constexpr double kMost = 2000;  // limits the memory for few small dots
    return std::max<std::int64_t>(1, static_cast<std::int64_t>(std::min(kMost, side / least)));
}

}  // namespace

Crowd::Crowd(std::span<const Point> points, std::span<const double> diameters, const Domain& domain)
    : points_(points.begin(), points.end()),
      diameters_(diameters),
      domain_(domain),
      next_(points.size(), kNone) {
    const double widest =
        diameters.empty() ? domain.width : *std::max_element(diameters.begin(), diameters.end());
    columns_ = cells_along(domain.width, kApart * widest);
    rows_ = cells_along(domain.height, kApart * widest);
    first_.assign(static_cast<std::size_t>(columns_ * rows_), kNone);
    for (std::size_t dot = 0; dot < points_.size(); ++dot) {
        std::uint32_t& first = first_in(cell_of(points_[dot]));
        next_[dot] = first;
        first = static_cast<std::uint32_t>(dot);
    }
}

void Crowd::move(std::size_t dot, Point to) {
    std::uint32_t* link = &first_in(cell_of(points_[dot]));
    while (*link != dot) link = &next_[*link];
    *link = next_[dot];
    points_[dot] = to;
    std::uint32_t& first = first_in(cell_of(to));
    next_[dot] = first;
    first = static_cast<std::uint32_t>(dot);
}

bool Crowd::is_too_near(std::size_t dot, Point to) const {
    const auto [column, row] = cell_of(to);
    // With less than three cells along a side, a neighbour would be met twice.
    const std::int64_t across = std::min<std::int64_t>(3, columns_);
    const std::int64_t up = std::min<std::int64_t>(3, rows_);
    for (std::int64_t j = 0; j < up; ++j)
        for (std::int64_t i = 0; i < across; ++i) {
            std::int64_t x = column + i - 1, y = row + j - 1;
            if (domain_.wraps() || columns_ < 3) x = (x + columns_) % columns_;
            if (domain_.wraps() || rows_ < 3) y = (y + rows_) % rows_;
            if (x < 0 || x >= columns_ || y < 0 || y >= rows_) continue;
            for (std::uint32_t other = first_[static_cast<std::size_t>(y * columns_ + x)];
                 other != kNone; other = next_[other]) {
                if (other == dot) continue;
                const double reach = kApart * (diameters_[dot] + diameters_[other]) / 2;
                const double squared = squared_distance(to, points_[other]);
                if (squared < reach * reach &&
                    squared < squared_distance(points_[dot], points_[other]))
                    return true;
            }
        }
    return false;
}

Crowd::Cell Crowd::cell_of(Point place) const {
    const auto index = [](double at, double side, std::int64_t cells) {
        const auto cell =
            static_cast<std::int64_t>(std::floor(at / side * static_cast<double>(cells)));
        return std::clamp<std::int64_t>(cell, 0, cells - 1);
    };
    return {index(place.x, domain_.width, columns_), index(place.y, domain_.height, rows_)};
}

std::uint32_t& Crowd::first_in(Cell cell) {
    return first_[static_cast<std::size_t>(cell.row * columns_ + cell.column)];
}

double Crowd::squared_distance(Point a, Point b) const {
    double dx = std::abs(a.x - b.x), dy = std::abs(a.y - b.y);
    if (domain_.wraps()) {
        dx = std::min(dx, domain_.width - dx);
        dy = std::min(dy, domain_.height - dy);
    }
    return dx * dx + dy * dy;
}

}  // namespace lacuna::stippling
