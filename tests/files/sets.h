// Point sets for tests of files and pictures.
#pragma once

#include <lacuna/lacuna.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace lacuna::files {

// Numbers that a careless writer would change: long decimals, tiny, huge, whole, neighbouring ones.
inline std::vector<Point> awkward_points() {
    using Limits = std::numeric_limits<double>;
    return {{0.1, 1.0 / 3},
            {0.0, 1.0},
            {std::nextafter(1.0, 0.0), std::nextafter(1.0, 2.0)},
            {Limits::denorm_min(), Limits::min()},
            {Limits::max(), 1e22},
            {123456789.0, 0x1.fffffffp-31},
            {-0.0, 5e-5}};
}

// `count` points of the unit square, spread by the golden ratio.
inline std::vector<Point> spread_points(std::size_t count) {
    constexpr double kGolden = 0.6180339887498949;
    std::vector<Point> points(count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto step = static_cast<double>(i);
        points[i] = {(step + 0.5) / static_cast<double>(count),
                     step * kGolden - std::floor(step * kGolden)};
    }
    return points;
}

}  // namespace lacuna::files
