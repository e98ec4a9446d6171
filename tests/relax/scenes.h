// Points, fields and domains that are hard on relaxation, each small enough for brute force.
#pragma once

#include <lacuna/lacuna.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <ostream>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "fields.h"
#include "lattice/lattice.h"

namespace lacuna::relaxing::tests {

struct Scene {
    std::string name;
    std::vector<Point> points;
    std::optional<Field> field;
    RelaxOptions options;

    const Field* field_or_null() const { return field ? &*field : nullptr; }
    Lattice lattice() const { return make_lattice(points.size(), field_or_null(), options); }
    std::vector<Site> sites(const Lattice& lattice) const {
        return sites_of(points, lattice, options);
    }
};

inline std::ostream& operator<<(std::ostream& out, const Scene& scene) {
    return out << scene.name;
}

inline RelaxOptions on(double width, double height, Boundary boundary) {
    RelaxOptions options;
    options.domain.width = width;
    options.domain.height = height;
    options.domain.boundary = boundary;
    return options;
}

inline std::vector<Point> random_points(std::size_t count, double width, double height,
                                        std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::vector<Point> points;
    for (std::size_t i = 0; i < count; ++i) {
        const double x = std::ldexp(static_cast<double>(random() >> 11), -53);
        const double y = std::ldexp(static_cast<double>(random() >> 11), -53);
        points.push_back({x * width, y * height});
    }
    return points;
}

// A thin ring on white, as a drawing has.
inline Field ring_field(std::uint32_t columns, std::uint32_t rows) {
    using lacuna::tests::made_field;
    return made_field(columns, rows, [](double x, double y) {
        return std::abs(std::hypot(x - 0.5, y - 0.5) - 0.35) < 0.02 ? 1.0 : 0.0;
    });
}

// One pixel with importance among 20 x 14.
inline Field pixel_field() {
    Field field{20, 14, std::vector<double>(20 * 14, 0)};
    field.importance[3 * 20 + 17] = 1;
    return field;
}

// Each pixel differs from the next ones by up to 2^50.
inline Field powers_field(std::uint32_t columns, std::uint32_t rows) {
    Field field{columns, rows, {}};
    for (std::uint32_t i = 0; i < columns * rows; ++i)
        field.importance.push_back(std::ldexp(1, static_cast<int>(i * 37 % 51)));
    return field;
}

inline std::vector<Scene> scenes() {
    using namespace lacuna::tests;
    const RelaxOptions torus = on(1, 1, Boundary::torus);
    const RelaxOptions box = on(1, 1, Boundary::box);
    const std::vector<Point> edges{{0, 0}, {1, 0}, {0, 1}, {1, 1}, {0.5, 0}, {0, 0.5}, {0.5, 1}};
    std::vector<Scene> all{
        {"one on a torus", {{0.3, 0.8}}, {}, torus},
        {"one in a box", {{0.3, 0.8}}, {}, box},
        {"two on one spot of a torus", {{0.5, 0.5}, {0.5, 0.5}}, {}, torus},
        {"forty on one spot", std::vector<Point>(40, {0.25, 0.75}), {}, box},
        {"on the edges of a torus", edges, {}, torus},
        {"on the edges of a box", edges, {}, box},
        {"random on a torus", random_points(100, 1, 1, 1), {}, torus},
        {"random on a wide torus", random_points(60, 30, 1, 2), {}, on(30, 1, Boundary::torus)},
        {"random in a tall box", random_points(20, 1, 17, 3), {}, on(1, 17, Boundary::box)},
        {"three on the widest torus",
         random_points(3, 1000, 1, 4),
         {},
         on(1000, 1, Boundary::torus)},
        {"all in a corner", random_points(50, 1e-3, 1e-3, 5), {}, torus},
        {"few over a ramp", random_points(9, 1, 1, 6), ramp_field(40, 40), torus},
        {"many over a ramp", random_points(300, 1, 1, 7), ramp_field(31, 23), box},
        {"a step of 1000", random_points(100, 1, 1, 8), step_field(40, 40, 1000), torus},
        {"white holes", random_points(80, 1, 1, 9), white_holes_field(50, 50), box},
        {"a ring on white", random_points(40, 1, 1, 10), ring_field(60, 60), box},
        {"one pixel of a box", random_points(30, 1, 1, 12), pixel_field(), box},
        {"one pixel of a torus", random_points(30, 1, 1, 13), pixel_field(), torus},
        {"a ring on a torus", random_points(40, 1, 1, 11), ring_field(60, 60), torus},
        {"noise", random_points(60, 1, 1, 12), noise_field(48, 48, 3), torus},
        {"shares of a millionth", random_points(60, 1, 1, 13), sizes_field(48, 48, 4), box},
        {"a step of 10^12", random_points(100, 1, 1, 20), step_field(41, 39, 1e12), box},
        {"powers of two on a torus", random_points(200, 1, 1, 21), powers_field(37, 29), torus},
        {"one dark pixel", random_points(50, 1, 1, 14), one_dark_pixel_field(30, 30), torus},
        {"pixels three times as wide as tall", random_points(70, 3, 1, 15), ramp_field(20, 20),
         on(3, 1, Boundary::torus)},
        {"tall pixels in one row", random_points(12, 1, 1, 16), ramp_field(37, 1), box},
        {"more than there is room for", random_points(400, 1, 1, 17), ring_field(20, 20), torus},
        {"seven hundred in a corner of a box", random_points(700, 0.02, 0.02, 18), {}, box},
        {"three in a long strip", random_points(3, 150, 1, 19), constant_field(3000, 20, 1),
         on(150, 1, Boundary::box)},
        {"far from the only dark pixel", {{0.9, 0.9}, {0.95, 0.9}, {0.9, 0.95}}, {}, box}};
    Field& last = all.back().field.emplace(constant_field(24, 24, 0));
    last.importance[24 * 20 + 3] = 1;
    return all;
}

}  // namespace lacuna::relaxing::tests
