// Fields of every hostile kind, maximal sets that follow them, and slow ways to look at both.
#pragma once

#include <gtest/gtest.h>
#include <lacuna/lacuna.h>
#include <lacuna/verify.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "verify/domain.h"

namespace lacuna::verify {

// A field, and what is asked of a set that follows it.
struct FieldCase {
    std::string name;
    Field field;
    double scale = 1;
    Domain domain{1, 1, false};

    Claim claim() const {
        Claim claim;
        claim.width = domain.width;
        claim.height = domain.height;
        claim.boundary = domain.torus ? Boundary::torus : Boundary::box;
        claim.field = &field;
        claim.scale = scale;
        return claim;
    }
    double tolerance() const { return domain.longer_side() * 0x1p-27; }

    // Nothing where there is no importance. Of a place on a border, the radius of the pixel right
    // of it or above it.
    std::optional<double> radius_at(Point at) const {
        const auto index = [](double share, std::uint32_t count) {
            const auto pixel = static_cast<std::int64_t>(std::floor(share * count));
            return static_cast<std::size_t>(
                std::clamp<std::int64_t>(pixel, 0, std::int64_t{count} - 1));
        };
        const std::size_t column = index(at.x / domain.width, field.columns);
        const std::size_t row = field.rows - 1 - index(at.y / domain.height, field.rows);
        const double importance = field.importance[row * field.columns + column];
        if (importance == 0) return std::nullopt;
        return scale / std::sqrt(importance);
    }

    // Of the pixels that a sample may be said to lie on, as borders may be off by 2^-28 of the
    // longer side: the largest radius, which holds for what it covers.
    std::optional<double> most_radius_near(Point at) const {
        std::optional<double> most;
        const auto wrapped = [&](double place, double side) {
            return domain.torus ? place - side * std::floor(place / side) : place;
        };
        const double blur = domain.longer_side() * 0x1p-28;
        for (const double dx : {-blur, 0.0, blur})
            for (const double dy : {-blur, 0.0, blur})
                if (const auto radius = radius_at(
                        {wrapped(at.x + dx, domain.width), wrapped(at.y + dy, domain.height)}))
                    most = std::max(most.value_or(0), *radius);
        return most;
    }

    // How far the spot is over its limit, by a look at all points; nothing where none may lie.
    std::optional<double> over(std::span<const Point> points, Point spot) const {
        const std::optional<double> radius = radius_at(spot);
        if (!radius) return std::nullopt;
        double least = std::numeric_limits<double>::infinity();
        for (const Point& point : points)
            least = std::min(least, domain.distance(spot, point) -
                                        std::min(*radius, most_radius_near(point).value()));
        return least;
    }

    // The same for the barest spot of a raster, moved off the borders of pixels.
    double most_over_of_raster(std::span<const Point> points, int steps) const {
        std::vector<double> radii;
        for (const Point& point : points) radii.push_back(most_radius_near(point).value());
        double most = -std::numeric_limits<double>::infinity();
        for (int i = 0; i < steps; ++i)
            for (int j = 0; j < steps; ++j) {
                const Point spot{domain.width * (i + 0.4987) / steps,
                                 domain.height * (j + 0.5013) / steps};
                const auto radius = radius_at(spot);
                if (!radius) continue;
                double least = std::numeric_limits<double>::infinity();
                for (std::size_t k = 0; k < points.size(); ++k)
                    least = std::min(
                        least, domain.distance(spot, points[k]) - std::min(*radius, radii[k]));
                most = std::max(most, least);
            }
        return most;
    }
};

inline double any_in(std::mt19937_64& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

inline Point any_place(std::mt19937_64& random, const Domain& domain) {
    return {any_in(random, 0, domain.width), any_in(random, 0, domain.height)};
}

// Radii from the scale on to `range` times as much, another on every pixel.
inline Field noise(std::mt19937_64& random, std::uint32_t columns, std::uint32_t rows,
                   double range) {
    Field field{columns, rows, std::vector<double>(std::size_t{columns} * rows)};
    for (double& importance : field.importance)
        importance = std::pow(range, -2 * any_in(random, 0, 1));
    return field;
}

// Of some hundred points or fewer when filled.
inline FieldCase hostile_case(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    FieldCase made;
    const double width = std::pow(10, any_in(random, -3, 3));
    made.domain = {width, width * any_in(random, 0.3, 2.5), random() % 2 == 0};
    const double longer = made.domain.longer_side();
    const auto few = [&] { return static_cast<std::uint32_t>(1 + random() % 7); };
    const auto with_zeros = [&](auto is_zero) {
        for (std::uint32_t row = 0; row < made.field.rows; ++row)
            for (std::uint32_t column = 0; column < made.field.columns; ++column)
                if (is_zero(column, row))
                    made.field.importance[std::size_t{row} * made.field.columns + column] = 0;
    };
    made.scale = longer * any_in(random, 0.08, 0.3);
    switch (seed % 9) {
        case 0:
            made.name = "noise";
            made.field = noise(random, few(), few(), 10);
            break;
        case 1:
            made.name = "fine noise";
            made.field = noise(random, 50 + few(), 40 + few(), 5);
            break;
        case 2:
            made.name = "one pixel";
            made.field = noise(random, 1, 1, 1);
            break;
        case 3:
            made.name = "one column";
            made.field = noise(random, 1, 3 + few(), 20);
            break;
        case 4:
            made.name = "one row of long pixels";
            made.field = noise(random, 100, 2, 8);
            break;
        case 5:
            made.name = "a checkerboard of zeros";
            made.field = noise(random, 3 + few(), 3 + few(), 3);
            with_zeros([](auto column, auto row) { return (column + row) % 2 == 0; });
            break;
        case 6:
            made.name = "islands";
            made.field = noise(random, 30, 30, 3);
            with_zeros([&](auto, auto) { return random() % 40 != 0; });
            break;
        case 7:
            made.name = "a range of a million";
            made.field = noise(random, 16, 16, 1e6);
            made.scale = longer * 0.04;
            break;
        default:
            made.name = "radii over the domain's sides";
            made.field = noise(random, few(), few(), 30);
            made.scale = longer * any_in(random, 0.5, 3);
            break;
    }
    return made;
}

}  // namespace lacuna::verify
