// Fields of ellipses at random, and slow ways to examine sets on them.
#pragma once

#include <lacuna/lacuna.h>
#include <lacuna/verify.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <random>
#include <span>
#include <string>

#include "verify/closest.h"
#include "verify/domain.h"
#include "verify/field_sets.h"

namespace lacuna::verify {

// A field with stretches. An ellipse is here the matrix M of its quadratic form: it holds the
// offset d if d M d < 1.
struct EllipseCase : FieldCase {
    Request request(std::uint64_t seed) const {
        Request request;
        request.domain.width = domain.width;
        request.domain.height = domain.height;
        request.domain.boundary = domain.torus ? Boundary::torus : Boundary::box;
        request.field = &field;
        request.scale = scale;
        if (mask) request.mask = &*mask;
        request.place.backend = "cpu";
        request.place.threads = 1;
        request.seed = seed;
        return request;
    }

    struct Form {
        double xx, xy, yy;
        double shorter;  // radius
        double length_of(double dx, double dy) const {
            return std::sqrt(xx * dx * dx + 2 * xy * dx * dy + yy * dy * dy);
        }
        double over(double dx, double dy) const { return shorter * (length_of(dx, dy) - 1); }
    };

    Form form_at(Point at) const {
        const auto [ratio, angle] = field.stretches[pixel_of(at, field.columns, field.rows)];
        const double radius = radius_at(at).value();
        const double longer = radius * std::sqrt(ratio), shorter = radius / std::sqrt(ratio);
        const double c = std::cos(angle), s = std::sin(angle);
        const double far = 1 / (longer * longer), near = 1 / (shorter * shorter);
        return {c * c * far + s * s * near, c * s * (far - near), s * s * far + c * c * near,
                shorter};
    }

    bool is_open(Point at) const { return radius_at(at) && FieldCase::is_open(at); }

    // The shortest radius of all pixels that have one.
    double shortest_radius() const {
        double shortest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < field.importance.size(); ++i)
            if (field.importance[i] > 0)
                shortest = std::min(
                    shortest, scale / std::sqrt(field.importance[i] * field.stretches[i].ratio));
        return shortest;
    }

    Pair closest_of_all(std::span<const Point> points) const {
        const auto shorter_way = [&](double way, double side) {
            return domain.torus ? way - side * std::round(way / side) : way;
        };
        Pair closest;
        for (std::size_t i = 0; i < points.size(); ++i)
            for (std::size_t j = i + 1; j < points.size(); ++j) {
                const double dx = shorter_way(points[j].x - points[i].x, domain.width);
                const double dy = shorter_way(points[j].y - points[i].y, domain.height);
                const double ratio = std::max(form_at(points[i]).length_of(dx, dy),
                                              form_at(points[j]).length_of(dx, dy));
                if (ratio < closest.ratio) closest = {i, j, std::sqrt(dx * dx + dy * dy), 0, ratio};
            }
        return closest;
    }

    // How far the spot is over its limit, or nothing where no point may lie. Looks at all points
    // and, on a torus, at all of their images that may be near.
    std::optional<double> over(std::span<const Point> points, Point spot) const {
        if (!is_open(spot)) return std::nullopt;
        const Form own = form_at(spot);
        const int wraps = domain.torus ? 1 : 0;
        double least = std::numeric_limits<double>::infinity();
        for (const Point& point : points) {
            const Form form = form_at(point);
            for (int i = -wraps; i <= wraps; ++i)
                for (int j = -wraps; j <= wraps; ++j) {
                    const double dx = point.x + i * domain.width - spot.x;
                    const double dy = point.y + j * domain.height - spot.y;
                    least = std::min(least, std::max(form.over(dx, dy), own.over(dx, dy)));
                }
        }
        return least;
    }

    // How far the largest gap among the spots of a raster is over its limit.
    double most_over_of_raster(std::span<const Point> points, int steps) const {
        double most = -std::numeric_limits<double>::infinity();
        for (int i = 0; i < steps; ++i)
            for (int j = 0; j < steps; ++j)
                if (const auto spot_over = over(points, {domain.width * (i + 0.4987) / steps,
                                                         domain.height * (j + 0.5013) / steps}))
                    most = std::max(most, *spot_over);
        return most;
    }
};

// Ratios from 1 to 32, at angles that are random on every pixel, or swirl around the middle.
inline void stretch_field(std::mt19937_64& random, bool swirls, Field& field) {
    const double greatest = std::pow(32, any_in(random, 0, 1));
    field.stretches.resize(field.importance.size());
    for (std::size_t i = 0; i < field.stretches.size(); ++i) {
        const double x = static_cast<double>(i % field.columns) - field.columns / 2.0;
        const double y = static_cast<double>(i / field.columns) - field.rows / 2.0;
        if (swirls)
            field.stretches[i] = {greatest, 2 * std::atan2(y, x) + 0.01 * x * y};
        else
            field.stretches[i] = {std::pow(greatest, any_in(random, 0, 1)), any_in(random, -4, 4)};
    }
}

// A field that is full with about a hundred points.
inline EllipseCase ellipse_case(std::uint64_t seed) {
    std::mt19937_64 random(seed + 77000);
    EllipseCase made;
    const double width = any_in(random, 0.5, 20);
    made.domain = {width, width * any_in(random, 0.5, 2), seed % 2 == 0};
    const auto some = [&] { return static_cast<std::uint32_t>(2 + random() % 12); };
    const std::uint64_t kind = seed / 2 % 4;
    made.name = kind == 0   ? "random angles"
                : kind == 1 ? "a swirl"
                : kind == 2 ? "one pixel"
                            : "with zeros";
    made.field = kind == 2 ? noise(random, 1, 1, 1) : noise(random, some(), some(), 2);
    if (kind == 3)
        for (double& importance : made.field.importance)
            if (random() % 3 == 0) importance = 0;
    made.field.importance.front() = std::max(made.field.importance.front(), 0.5);
    stretch_field(random, kind == 1 || seed % 3 == 0, made.field);
    if (seed % 5 == 0) {
        made.name += ", a mask";
        made.mask = Mask{some(), some(), {}};
        made.mask->allowed.resize(std::size_t{made.mask->columns} * made.mask->rows);
        for (std::uint8_t& allowed : made.mask->allowed) allowed = random() % 4 != 0 ? 1 : 0;
        made.mask->allowed.front() = 1;
    }
    made.scale = std::sqrt(made.domain.width * made.domain.height) * any_in(random, 0.06, 0.12);
    if (!made.domain.torus) return made;
    // No ellipse may be longer than the shorter side.
    const double most = std::min(made.domain.width, made.domain.height) / 2.001 / made.scale;
    for (std::size_t i = 0; i < made.field.importance.size(); ++i)
        if (double& ratio = made.field.stretches[i].ratio; made.field.importance[i] > 0)
            ratio = std::min(ratio, most * most * made.field.importance[i]);
    return made;
}

}  // namespace lacuna::verify
