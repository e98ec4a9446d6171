// Importance fields for several tests: made ones, and the photograph reduced.
#pragma once

#include <lacuna/lacuna.h>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#ifdef LACUNA_RACCOON
#include "pictures/image.h"
#include "pictures/importance.h"
#endif

namespace lacuna::tests {

// The field whose importance at the middle of each pixel is of(x, y): both in (0, 1), y upwards.
template <typename Of>
Field made_field(std::uint32_t columns, std::uint32_t rows, Of of) {
    Field field{columns, rows, {}};
    for (std::uint32_t row = 0; row < rows; ++row)
        for (std::uint32_t column = 0; column < columns; ++column)
            field.importance.push_back(of((column + 0.5) / columns, 1 - (row + 0.5) / rows));
    return field;
}

// The field with ellipses: of(x, y) is the stretch at the middle of each pixel.
template <typename Of>
Field stretched(Field field, Of of) {
    for (std::uint32_t row = 0; row < field.rows; ++row)
        for (std::uint32_t column = 0; column < field.columns; ++column)
            field.stretches.push_back(
                of((column + 0.5) / field.columns, 1 - (row + 0.5) / field.rows));
    return field;
}

// Ellipses that turn around the middle.
inline Field swirled(Field field, double ratio) {
    return stretched(std::move(field), [&](double x, double y) {
        return Stretch{ratio, std::atan2(y - 0.5, x - 0.5) + 1.2};
    });
}

// Ratios from 1 to `ratio`, at all angles, pixel by pixel.
inline Field stretched_at_random(Field field, double ratio, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    return stretched(std::move(field), [&](double, double) {
        const double power = static_cast<double>(random() % 1000) / 1000;
        return Stretch{std::pow(ratio, power), static_cast<double>(random() % 6283) / 1000 - 3};
    });
}

inline Field constant_field(std::uint32_t columns, std::uint32_t rows, double value = 1) {
    return made_field(columns, rows, [&](double, double) { return value; });
}

// From 0.02 at the left to 1 at the right; in a single column from the bottom to the top.
inline Field ramp_field(std::uint32_t columns, std::uint32_t rows) {
    return made_field(columns, rows,
                      [&](double x, double y) { return 0.02 + 0.98 * (columns == 1 ? y : x); });
}

// 1 on the left half, 1 / ratio on the right.
inline Field step_field(std::uint32_t columns, std::uint32_t rows, double ratio = 10) {
    return made_field(columns, rows, [&](double x, double) { return x < 0.5 ? 1 : 1 / ratio; });
}

// Half grey with round holes where no sample is wanted, one of them over a corner.
inline Field white_holes_field(std::uint32_t columns, std::uint32_t rows) {
    return made_field(columns, rows, [](double x, double y) {
        const bool is_white = std::hypot(x - 0.3, y - 0.6) < 0.2 || std::hypot(x - 1, y - 1) < 0.3;
        return is_white ? 0 : 0.5;
    });
}

// All pale except one dark pixel, whose radius is 20 times smaller.
inline Field one_dark_pixel_field(std::uint32_t columns, std::uint32_t rows) {
    Field field = constant_field(columns, rows, 1.0 / 400);
    field.importance[field.importance.size() / 3] = 1;
    return field;
}

// Independent pixels: radii differ by up to a factor of 30, one pixel in eight is white.
inline Field noise_field(std::uint32_t columns, std::uint32_t rows, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    return made_field(columns, rows, [&](double, double) {
        if (random() % 8 == 0) return 0.0;
        const double decades = static_cast<double>(random() % 1000) / 1000;
        return std::pow(900, -decades);
    });
}

// Radii differ by up to a factor of 1,000; wide ones are rare, as in a pale picture.
inline Field sizes_field(std::uint32_t columns, std::uint32_t rows, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    return made_field(columns, rows, [&](double, double) {
        const double share = static_cast<double>(random() % 1000) / 1000;
        return std::pow(1e-6, std::pow(share, 4));
    });
}

#ifdef LACUNA_RACCOON
// The photograph in examples/, as importance, by the means of blocks of pixels. `columns` divides
// 1024 and 4 divides `columns`.
inline Field raccoon_field(std::uint32_t columns) {
    static const Field whole = pictures::importance_of(pictures::read_image(LACUNA_RACCOON), {});
    const std::uint32_t side = whole.columns / columns;
    Field field{columns, whole.rows / side, {}};
    for (std::uint32_t row = 0; row < field.rows; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            double sum = 0;
            for (std::uint32_t y = row * side; y < (row + 1) * side; ++y)
                for (std::uint32_t x = column * side; x < (column + 1) * side; ++x)
                    sum += whole.importance[std::size_t{y} * whole.columns + x];
            field.importance.push_back(sum / side / side);
        }
    }
    return field;
}
#endif

// The scale at which `count` samples are expected (docs/design.md, section 5).
inline double scale_of(const Field& field, double area, double count) {
    const double sum = std::accumulate(field.importance.begin(), field.importance.end(), 0.0);
    return std::sqrt(0.6966 * area * sum / static_cast<double>(field.importance.size()) / count);
}

}  // namespace lacuna::tests
