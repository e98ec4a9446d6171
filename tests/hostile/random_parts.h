// The parts of random requests: hostile fields, masks, polygons, classes and kept points.
#pragma once

#include <lacuna/domains.h>
#include <lacuna/lacuna.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

#include "hostile/made.h"
#include "hostile/random_polygons.h"
#include "judge/judge.h"

namespace lacuna::tests {

// Random numbers. Those of number k of a seed do not depend on the numbers before.
class Chooser {
public:
    Chooser(std::uint64_t seed, std::uint64_t number) {
        std::seed_seq mixed{seed, seed >> 32, number, number >> 32};
        random_.seed(mixed);
    }

    std::mt19937_64& random() { return random_; }
    std::uint32_t below(std::uint32_t end) { return static_cast<std::uint32_t>(random_() % end); }
    bool one_in(std::uint32_t many) { return below(many) == 0; }
    double in(double low, double high) { return judge::any_in(random_, low, high); }
    // A number from low to high; all powers are equally likely.
    double power(double low, double high) {
        return std::min(high, low * std::pow(high / low, in(0, 1)));
    }
    std::uint32_t some(double most) { return static_cast<std::uint32_t>(power(1, most)); }

private:
    std::mt19937_64 random_;
};

// Importance of up to 1, over a range of up to `range`; in part of the fields with zeros.
inline Field random_field(Chooser& choose, double most_pixels, double range) {
    Field field{choose.some(most_pixels), choose.some(most_pixels), {}};
    if (choose.one_in(8)) (choose.one_in(2) ? field.columns : field.rows) = 1;
    range = choose.power(1, range);
    const bool has_two = choose.one_in(2);
    const std::uint32_t kind = choose.below(4);  // of zeros: at random, a checkerboard, islands
    for (std::uint32_t row = 0; row < field.rows; ++row)
        for (std::uint32_t column = 0; column < field.columns; ++column) {
            const double share = has_two ? (choose.one_in(2) ? 1 : 1 / range)  //
                                         : choose.power(1 / range, 1);
            const bool is_zero = kind == 0   ? choose.one_in(8)
                                 : kind == 1 ? (row + column) % 2 == 1
                                             : kind == 2 && !choose.one_in(40);
            field.importance.push_back(is_zero ? 0 : share);
        }
    field.importance[choose.random()() % field.importance.size()] = 1;
    return field;
}

// Ratios from 1 to 32, at angles that are random on every pixel, or swirl around the middle.
inline void stretch_field(Chooser& choose, bool swirls, Field& field) {
    const double greatest = std::pow(32, choose.in(0, 1));
    field.stretches.resize(field.importance.size());
    for (std::size_t i = 0; i < field.stretches.size(); ++i) {
        const double x = static_cast<double>(i % field.columns) - field.columns / 2.0;
        const double y = static_cast<double>(i / field.columns) - field.rows / 2.0;
        if (swirls)
            field.stretches[i] = {greatest, 2 * std::atan2(y, x) + 0.01 * x * y};
        else
            field.stretches[i] = {std::pow(greatest, choose.in(0, 1)), choose.in(-4, 4)};
    }
}

inline double mean_of(const Field& field) {
    return std::accumulate(field.importance.begin(), field.importance.end(), 0.0) /
           static_cast<double>(field.importance.size());
}

// A picture with so few pixels that most points begin far from importance.
inline Field sparse_field(Chooser& choose) {
    Field field{choose.some(80), choose.some(80), {}};
    field.importance.assign(std::size_t{field.columns} * field.rows, 0);
    const double range = choose.power(1, 1e6);
    for (std::uint32_t many = 1 + choose.below(6); many != 0; --many)
        field.importance[choose.random()() % field.importance.size()] = choose.power(1 / range, 1);
    return field;
}

inline Mask random_mask(Chooser& choose) {
    const std::uint32_t kind = choose.below(8);
    const auto side = [&](std::uint32_t most) { return 1 + choose.below(most); };
    Mask mask{side(40), side(40), {}};
    if (kind == 0) mask = {100 + side(200), 100 + side(200), {}};
    if (kind == 1) mask = {60, 60, {}};
    if (kind == 2) (choose.one_in(2) ? mask.columns : mask.rows) = 1;
    const std::uint32_t many = 2 + choose.below(8);
    const auto is_allowed = [&](std::uint32_t column, std::uint32_t row) {
        if (kind == 1) return choose.one_in(40);        // islands
        if (kind == 3) return (column + row) % 2 == 0;  // a checkerboard
        if (kind == 4) return false;                    // one pixel
        if (kind == 5) return column % 5 == 2 || (row % 7 == 3 && column > row);
        if (kind == 6) return !choose.one_in(many);
        return choose.one_in(2);
    };
    for (std::uint32_t row = 0; row < mask.rows; ++row)
        for (std::uint32_t column = 0; column < mask.columns; ++column)
            mask.allowed.push_back(is_allowed(column, row) ? 1 : 0);
    mask.allowed[choose.random()() % mask.allowed.size()] = 255;
    return mask;
}

// Lines and points to avoid; nothing is inside of them.
inline std::vector<PolygonRing> random_lines(Chooser& choose, const Domain& domain) {
    std::vector<PolygonRing> lines(1 + choose.below(8));
    for (PolygonRing& line : lines) {
        for (std::uint32_t corners = 1 + choose.below(4); corners != 0; --corners)
            line.push_back(judge::any_place(choose.random(), domain));
        for (std::size_t back = line.size(); back > 1; --back) line.push_back(line[back - 1]);
    }
    return lines;
}

// The radii or, by no rule, distances of classes as nobody would ask for them: two to sixteen that
// leave each other no room, ignore each other, or are not drawn. The least distance is 1.
inline void choose_classes(Chooser& choose, Made& made, double ratio) {
    Classes& classes = made.request.classes;
    const std::size_t count = 2 + choose.below(choose.one_in(4) ? 15 : 3);
    for (std::size_t i = 0; i < count; ++i) {
        made.radii.push_back(choose.power(1, ratio));
        const double* const first = std::find(made.radii.data(), &made.radii.back(), made.radii[i]);
        const bool is_size =
            made.is(kClasses, "sizes") && i > 0 && first == &made.radii.back() && !choose.one_in(3);
        classes.names.push_back(is_size ? classes.names.back() : "class-" + std::to_string(i));
    }
    if (made.is(kClasses, "given")) {
        made.radii.clear();
        classes.distances.resize(count * count);
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t j = 0; j <= i; ++j)
                classes.distances[i * count + j] = classes.distances[j * count + i] =
                    i != j && choose.one_in(4) ? 0 : choose.power(1, ratio);
    }
    made.scale_classes(1);
    made.scale_classes(1 / made.least_distance());
    if (choose.one_in(2)) return;
    classes.weights.assign(count, 1);
    for (std::size_t i = 1; i < count; ++i)
        classes.weights[i] = choose.one_in(4) ? 0 : choose.power(1e-4, 1e4);
}

}  // namespace lacuna::tests
