// Finds the nearest white around each dot, pixel by pixel, and moves or shrinks the dot.
#include "stipple/keep_inside.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "base/polling.h"
#include "stipple/crowd.h"
#include "stipple/dot_size.h"

namespace lacuna::stippling {
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
    if (!white.domain.wraps()) return point;
    const auto wrapped = [](double x, double side) {
        const double in = x - side * std::floor(x / side);
        return in < side ? in : 0;
    };
    return {wrapped(point.x, white.domain.width), wrapped(point.y, white.domain.height)};
}

double nearest_in_pixel(double from, std::int64_t pixel, double side) {
    const double edge = static_cast<double>(pixel) * side;
    return std::clamp(from, edge, edge + side);
}

// A place on a dark pixel of a dot that lies on its edge, where white begins: half way to the
// middle of the pixel. On an edge or a corner rounding decides which pixel the dot is on, so the
// dark one may be any of those around it. Nothing if all of these are white.
std::optional<Point> off_the_edge(Point from, const White& white) {
    constexpr double kBeside = 1e-6;  // of a pixel
    const auto towards_middle = [](double at, double side, std::uint32_t pixels) {
        const double step = side / pixels;
        const double middle = (std::min(std::floor(at / step), pixels - 1.0) + 0.5) * step;
        return (at + middle) / 2;
    };
    const double width = white.domain.width, height = white.domain.height;
    for (const int right : {0, -1, 1})
        for (const int up : {0, -1, 1}) {
            const Point at{
                std::clamp(from.x + right * kBeside * width / white.field.columns, 0., width),
                std::clamp(from.y + up * kBeside * height / white.field.rows, 0., height)};
            const Point inner{towards_middle(at.x, width, white.field.columns),
                              towards_middle(at.y, height, white.field.rows)};
            if (importance_at(inner, white.field, white.domain) != 0) return inner;
        }
    return std::nullopt;
}

// Moves a dot of this radius. Each step goes straight away from the nearest white, as far as the
// dot overhangs. A step that brings it nearer to some white, or too near to another dot, is taken
// back, and halved.
void pull(std::size_t dot, double radius, const White& white, Crowd& crowd) {
    constexpr int kSteps = 24;
    std::optional<Near> near = nearest_white(white, crowd.at(dot), radius);
    double share = 1;
    for (int step = 0; near && step < kSteps; ++step) {
        const Point from = crowd.at(dot);
        Point to;
        if (near->distance > 0) {
            const double move = share * (radius * (1 + kTouch) - near->distance) / near->distance;
            to = in_domain({from.x + move * (from.x - near->point.x),
                            from.y + move * (from.y - near->point.y)},
                           white);
        } else {
            const std::optional<Point> inner = off_the_edge(from, white);
            if (!inner) return;
            to = *inner;
        }
        const std::optional<Near> next = nearest_white(white, to, radius);
        const bool is_nearer = next && next->distance <= near->distance;
        if (is_nearer || (near->distance > 0 && crowd.is_too_near(dot, to))) {
            share /= 2;
            continue;
        }
        crowd.move(dot, to);
        near = next;
    }
}

}  // namespace

std::optional<Point> White::nearest(Point from, double reach) const {
    const double width = domain.width, height = domain.height;
    const bool torus = domain.wraps();
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
        ask_after(static_cast<std::size_t>(last - first + 1));
        const double* row =
            &field.importance[(field.rows - 1 - wrap(y, rows)) * std::size_t{field.columns}];
        const double nearest_y = nearest_in_pixel(from.y, y, step_y);
        for (std::int64_t x = first; x <= last; ++x)
            if (row[wrap(x, columns)] == 0) offer({nearest_in_pixel(from.x, x, step_x), nearest_y});
    }
    return best;
}

std::vector<double> widths_of(const White& white, double most) {
    const Field& field = white.field;
    const double step_x = white.domain.width / field.columns;
    const double step_y = white.domain.height / field.rows;
    const auto middle = [&](std::int64_t column, std::int64_t row) {
        return Point{(static_cast<double>(column) + 0.5) * step_x,
                     white.domain.height - (static_cast<double>(row) + 0.5) * step_y};
    };
    const std::int64_t columns = field.columns, rows = field.rows;
    const auto index = [&](std::int64_t column, std::int64_t row) {
        return static_cast<std::size_t>(row * columns + column);
    };
    std::vector<double> widths(field.importance.size());
    std::vector<double> radii(widths.size());
    for (std::int64_t row = 0; row < rows; ++row)
        for (std::int64_t column = 0; column < columns; ++column) {
            const std::size_t i = index(column, row);
            if (field.importance[i] == 0) continue;
            const std::optional<Near> near = nearest_white(white, middle(column, row), most / 2);
            widths[i] = 2 * (radii[i] = near ? near->distance : most / 2);
        }
    // A disk that fits is as wide for every pixel that it reaches.
    for (std::int64_t row = 0; row < rows; ++row)
        for (std::int64_t column = 0; column < columns; ++column) {
            const double radius = radii[index(column, row)];
            const auto across = static_cast<std::int64_t>(radius / step_x);
            const auto up = static_cast<std::int64_t>(radius / step_y);
            ask_after(static_cast<std::size_t>((2 * across + 1) * (2 * up + 1)));
            for (std::int64_t y = std::max<std::int64_t>(row - up, 0);
                 y <= std::min(row + up, rows - 1); ++y)
                for (std::int64_t x = std::max<std::int64_t>(column - across, 0);
                     x <= std::min(column + across, columns - 1); ++x) {
                    const double dx = static_cast<double>(x - column) * step_x;
                    const double dy = static_cast<double>(y - row) * step_y;
                    double& width = widths[index(x, y)];
                    if (width > 0 && dx * dx + dy * dy <= radius * radius)
                        width = std::max(width, 2 * radius);
                }
        }
    return widths;
}

void pull_inside(std::span<Point> points, std::span<const double> diameters, const White& white) {
    Crowd crowd(points, diameters, white.domain);
    for (std::size_t dot = 0; dot < points.size(); ++dot)
        pull(dot, diameters[dot] / 2, white, crowd);
    for (std::size_t dot = 0; dot < points.size(); ++dot) points[dot] = crowd.at(dot);
}

void fit_inside(std::span<const Point> points, std::span<double> diameters, const White& white,
                double least) {
    for (std::size_t i = 0; i < points.size(); ++i)
        if (const auto near = nearest_white(white, points[i], diameters[i] / 2))
            diameters[i] = std::max(least, 2 * near->distance);
}

}  // namespace lacuna::stippling
