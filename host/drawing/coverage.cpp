// Marks the positions of a raster that dots cover, and counts them.
#include "drawing/coverage.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/polling.h"
#include "plan/ellipse.h"

namespace lacuna::drawing {
namespace {

class Raster {
public:
    Raster(const Domain& domain, std::size_t dots) : domain_(domain) {
        constexpr double kLeast = 1 << 16, kMost = 1 << 22, kForADot = 64;
        const double all = std::clamp(kForADot * static_cast<double>(dots), kLeast, kMost);
        const double step = std::sqrt(domain.width * domain.height / all);
        columns_ = std::max(1.0, std::round(domain.width / step));
        rows_ = std::max(1.0, std::round(domain.height / step));
        covered_.resize(static_cast<std::size_t>(columns_ * rows_));
    }

    void cover(Point middle, const Ellipse& dot) {
        const double width = domain_.width / columns_, height = domain_.height / rows_;
        const QuadraticForm form = form_of(dot);
        // How far the ellipse reaches up; a row at y has the x between the two roots.
        const double reach = std::sqrt(form.xx) * dot.a * dot.b;
        const double top = middle.y + reach;
        // Positions are the middles of cells.
        for (double row = std::ceil((middle.y - reach) / height - 0.5); (row + 0.5) * height <= top;
             ++row) {
            const double y = (row + 0.5) * height - middle.y;
            const double centre = middle.x - form.xy * y / form.xx;
            const double half =
                std::sqrt(std::max(0.0, 1 - y / reach * (y / reach))) / std::sqrt(form.xx);
            const double begin = std::ceil((centre - half) / width - 0.5);
            const double end = std::floor((centre + half) / width + 0.5);
            for (double column = begin; column < end; ++column) put(column, row);
            ask_after(static_cast<std::size_t>(std::max(1.0, end - begin)));
        }
    }

    double area() const {
        const auto count = std::count(covered_.begin(), covered_.end(), std::uint8_t{1});
        return static_cast<double>(count) / (columns_ * rows_) * domain_.width * domain_.height;
    }

private:
    void put(double column, double row) {
        if (domain_.wraps()) {
            column -= columns_ * std::floor(column / columns_);
            row -= rows_ * std::floor(row / rows_);
        }
        if (column >= 0 && column < columns_ && row >= 0 && row < rows_)
            covered_[static_cast<std::size_t>(row * columns_ + column)] = 1;
    }

    const Domain& domain_;
    double columns_;
    double rows_;
    std::vector<std::uint8_t> covered_;
};

}  // namespace

double covered_area(std::span<const Point> points, std::span<const Ellipse> dots, double times,
                    const Domain& domain) {
    Raster raster(domain, points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        raster.cover(domain.from_corner(points[i]),
                     {times * dots[i].a, times * dots[i].b, dots[i].angle});
    return raster.area();
}

}  // namespace lacuna::drawing
