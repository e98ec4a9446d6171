// Finds the nearest white around each dot, pixel by pixel, and moves or shrinks the dot.
#include "drawing/keep_inside.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace lacuna::drawing {
namespace {

struct Near {
    Point point;
    double distance;
};

// The distance of dots to white is less exact than this share of their radius.
constexpr double kTouch = 1e-3;

std::optional<Near> nearest_white(const White& white, Point from, double reach) {
    const std::optional<Point> point = white.nearest(from, reach);
    if (!point) return std::nullopt;
    const double dx = from.x - point->x, dy = from.y - point->y;
    return Near{*point, std::sqrt(dx * dx + dy * dy)};
}

Point in_domain(Point point, const White& white) {
    if (white.boundary != Boundary::torus) return point;
    const auto wrapped = [](double x, double side) {
        const double in = x - side * std::floor(x / side);
        return in < side ? in : 0;
    };
    return {wrapped(point.x, white.width), wrapped(point.y, white.height)};
}

double nearest_in_pixel(double from, std::int64_t pixel, double side) {
    const double edge = static_cast<double>(pixel) * side;
    return std::clamp(from, edge, edge + side);
}

// Where a dot of this radius goes. Each step moves it straight away from the nearest white, as far
// as it overhangs. A step that brings it nearer to some white is taken back, and halved.
Point pulled(Point from, double radius, const White& white) {
    constexpr int kSteps = 24;
    Point best = from;
    std::optional<Near> near = nearest_white(white, from, radius);
    double share = 1;
    for (int step = 0; near && near->distance > 0 && step < kSteps; ++step) {
        const double move = share * (radius * (1 + kTouch) - near->distance) / near->distance;
        const Point moved = in_domain(
            {best.x + move * (best.x - near->point.x), best.y + move * (best.y - near->point.y)},
            white);
        const std::optional<Near> next = nearest_white(white, moved, radius);
        if (next && next->distance <= near->distance) {
            share /= 2;
            continue;
        }
        best = moved;
        near = next;
    }
    return best;
}

}  // namespace

std::optional<Point> White::nearest(Point from, double reach) const {
    const bool torus = boundary == Boundary::torus;
    const double step_x = width / field.columns, step_y = height / field.rows;
    std::optional<Point> best;
    double least = reach * reach;
    const auto offer = [&](Point point) {
        const double dx = point.x - from.x, dy = point.y - from.y;
        const double squared = dx * dx + dy * dy;
        if (squared >= least) return;
        least = squared;
        best = point;
    };
    const bool is_outside = from.x < 0 || from.x > width || from.y < 0 || from.y > height;
    if (!torus && is_outside) return from;
    if (!torus)
        for (const Point edge :
             {Point{0, from.y}, Point{width, from.y}, Point{from.x, 0}, Point{from.x, height}})
            offer(edge);
    const auto pixel = [](double place, std::int64_t pixels, bool wraps) {
        const auto at = static_cast<std::int64_t>(std::floor(place));
        return wraps ? at : std::clamp<std::int64_t>(at, 0, pixels - 1);
    };
    const std::int64_t columns = field.columns, rows = field.rows;
    const std::int64_t first = pixel((from.x - reach) / step_x, columns, torus);
    const std::int64_t last = pixel((from.x + reach) / step_x, columns, torus);
    const std::int64_t low = pixel((from.y - reach) / step_y, rows, torus);
    const std::int64_t high = pixel((from.y + reach) / step_y, rows, torus);
    const auto wrap = [](std::int64_t at, std::int64_t pixels) {
        return static_cast<std::size_t>((at % pixels + pixels) % pixels);
    };
    for (std::int64_t y = low; y <= high; ++y) {
        const double* row =
            &field.importance[(field.rows - 1 - wrap(y, rows)) * std::size_t{field.columns}];
        const double nearest_y = nearest_in_pixel(from.y, y, step_y);
        for (std::int64_t x = first; x <= last; ++x)
            if (row[wrap(x, columns)] == 0) offer({nearest_in_pixel(from.x, x, step_x), nearest_y});
    }
    return best;
}

void pull_inside(std::span<Point> points, std::span<const double> diameters, const White& white) {
    for (std::size_t i = 0; i < points.size(); ++i)
        points[i] = pulled(points[i], diameters[i] / 2, white);
}

void fit_inside(std::span<const Point> points, std::span<double> diameters, const White& white,
                double least) {
    for (std::size_t i = 0; i < points.size(); ++i)
        if (const auto near = nearest_white(white, points[i], diameters[i] / 2))
            diameters[i] = std::max(least, 2 * near->distance);
}

}  // namespace lacuna::drawing
