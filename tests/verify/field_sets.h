// Hostile fields of every kind, where samples may lie on them, and slow ways to examine both.
#pragma once

#include <lacuna/domains.h>
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
#include "verify/polygons_of.h"

namespace lacuna::verify {

// A field, and what is asked of a set that follows it.
struct FieldCase {
    std::string name;
    Field field;
    double scale = 1;
    Domain domain{1, 1, false};
    std::optional<Mask> mask{};
    std::vector<PolygonRing> rings{};
    double edge = 0;
    double border = 0;

    Claim claim() const {
        Claim claim;
        claim.domain.width = domain.width;
        claim.domain.height = domain.height;
        claim.domain.boundary = domain.torus ? Boundary::torus : Boundary::box;
        claim.field = &field;
        claim.scale = scale;
        if (mask) claim.mask = &*mask;
        if (!rings.empty()) claim.polygons = polygons_of(rings);
        claim.edge_tolerance = edge;
        claim.border = border;
        return claim;
    }
    double tolerance() const { return domain.longer_side() * 0x1p-27; }

    // The radius of a place, or nothing where the importance is 0. A place on a border has the
    // radius of the pixel at its right or above it.
    std::optional<double> radius_at(Point at) const {
        const double importance = field.importance[pixel_of(at, field.columns, field.rows)];
        if (importance == 0) return std::nullopt;
        return scale / std::sqrt(importance);
    }

    std::size_t pixel_of(Point at, std::uint32_t columns, std::uint32_t rows) const {
        const auto index = [](double share, std::uint32_t count) {
            const auto pixel = static_cast<std::int64_t>(std::floor(share * count));
            return static_cast<std::size_t>(
                std::clamp<std::int64_t>(pixel, 0, std::int64_t{count} - 1));
        };
        const std::size_t row = rows - 1 - index(at.y / domain.height, rows);
        return row * columns + index(at.x / domain.width, columns);
    }

    // Whether mask, polygons and border say that a spot must be covered.
    bool is_open(Point at) const {
        const double to_edges =
            std::min(std::min(at.x, domain.width - at.x), std::min(at.y, domain.height - at.y));
        return to_edges >= border &&
               (!mask || mask->allowed[pixel_of(at, mask->columns, mask->rows)] != 0) &&
               (rings.empty() || depth_of(at) > edge);
    }

    // How far inside the rings a place is. Looks at all edges.
    double depth_of(Point at) const {
        double least = std::numeric_limits<double>::infinity();
        bool inside = false;
        for (const PolygonRing& ring : rings)
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Point a = ring[i];
                const Point b = ring[(i + 1) % ring.size()];
                const double dx = b.x - a.x, dy = b.y - a.y;
                const double along = ((at.x - a.x) * dx + (at.y - a.y) * dy) / (dx * dx + dy * dy);
                const double share = std::isnan(along) ? 0 : std::clamp(along, 0.0, 1.0);
                least =
                    std::min(least, std::hypot(at.x - a.x - share * dx, at.y - a.y - share * dy));
                if ((a.y > at.y) != (b.y > at.y) &&
                    at.x < a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x))
                    inside = !inside;
            }
        return inside ? least : -least;
    }

    // The radius with which a sample covers spots: the largest one of all pixels on which it may
    // lie, as borders may be off by 2^-28 of the longer side.
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

    // How far the spot is over its limit, or nothing where no point may lie. Looks at all points.
    std::optional<double> over(std::span<const Point> points, Point spot) const {
        const std::optional<double> radius = radius_at(spot);
        if (!radius || !is_open(spot)) return std::nullopt;
        double least = std::numeric_limits<double>::infinity();
        for (const Point& point : points)
            least = std::min(least, domain.distance(spot, point) -
                                        std::min(*radius, most_radius_near(point).value()));
        return least;
    }

    // How far the largest gap among the spots of a raster is over its limit. The spots are moved
    // off the borders of pixels.
    double most_over_of_raster(std::span<const Point> points, int steps) const {
        std::vector<double> radii;
        for (const Point& point : points) radii.push_back(most_radius_near(point).value());
        double most = -std::numeric_limits<double>::infinity();
        for (int i = 0; i < steps; ++i)
            for (int j = 0; j < steps; ++j) {
                const Point spot{domain.width * (i + 0.4987) / steps,
                                 domain.height * (j + 0.5013) / steps};
                const auto radius = radius_at(spot);
                if (!radius || !is_open(spot)) continue;
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

// A field with a random radius on every pixel, from the scale to `range` times the scale.
inline Field noise(std::mt19937_64& random, std::uint32_t columns, std::uint32_t rows,
                   double range) {
    Field field{columns, rows, std::vector<double>(std::size_t{columns} * rows)};
    for (double& importance : field.importance)
        importance = std::pow(range, -2 * any_in(random, 0, 1));
    return field;
}

// A field that is full with a few hundred points at most.
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

// An island of irregular outline, perhaps with a lake, and perhaps a thin triangle across both.
inline std::vector<PolygonRing> any_rings(std::mt19937_64& random, const Domain& domain) {
    const Point middle{domain.width * any_in(random, 0.3, 0.7),
                       domain.height * any_in(random, 0.3, 0.7)};
    const auto star = [&](double least, double most) {
        PolygonRing ring;
        for (int i = 0; i < 12; ++i) {
            const double reach = any_in(random, least, most);
            ring.push_back({middle.x + domain.width * reach * std::cos(i * 0.5236),
                            middle.y + domain.height * reach * std::sin(i * 0.5236)});
        }
        return ring;
    };
    std::vector<PolygonRing> rings{star(0.25, 0.7)};
    if (random() % 2 == 0) rings.push_back(star(0.02, 0.2));
    if (random() % 2 == 0)
        rings.push_back({{0, middle.y},
                         {domain.width, middle.y * (1 + 1e-7)},
                         {domain.width, middle.y * (1 - 1e-7)}});
    return rings;
}

// A hostile field with a mask, polygons or a border that forbid samples in some places.
inline FieldCase closed_case(std::uint64_t seed) {
    FieldCase made = hostile_case(seed);
    std::mt19937_64 random(seed + 2);
    const std::uint64_t kind = random() % 4;
    made.name += kind == 0 ? ", polygons" : kind == 1 ? ", a border" : ", a mask";
    if (kind == 0) {
        made.rings = any_rings(random, made.domain);
        made.edge = made.scale / 16;
    }
    if (kind == 1) {
        made.domain.torus = false;
        made.border = made.domain.width * any_in(random, 0, 0.2);
    }
    if (kind < 2) return made;
    const auto side = [&] { return static_cast<std::uint32_t>(1 + random() % 40); };
    made.mask = Mask{side(), side(), {}};
    made.mask->allowed.resize(std::size_t{made.mask->columns} * made.mask->rows);
    for (std::uint8_t& allowed : made.mask->allowed) allowed = random() % kind != 0 ? 1 : 0;
    made.mask->allowed[random() % made.mask->allowed.size()] = 255;
    return made;
}

}  // namespace lacuna::verify
