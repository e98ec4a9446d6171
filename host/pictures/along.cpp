// The directions of a picture's edges, by the structure tensor: the products of the gradient's
// components, blurred. Its larger eigenvector points across the edges nearby.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

#include "base/angle.h"
#include "base/polling.h"
#include "base/power.h"
#include "pictures/blur.h"
#include "pictures/importance.h"

namespace lacuna::pictures {
namespace {

// The blur's radius is this part of the picture's shorter side, but at least one pixel.
constexpr std::size_t kPartOfSide = 200;
// The squared gradient of two grey levels in 255 a pixel: less than this is taken for noise.
constexpr double kNoise = 4.0 / (255 * 255);

struct Tensor {
    std::vector<double> xx, xy, yy;
};

// Gradients by Sobel's operator; y points upwards.
Tensor products_of_gradients(std::span<const double> values, std::size_t columns,
                             std::size_t rows) {
    Tensor tensor;
    for (std::vector<double>* const one : {&tensor.xx, &tensor.xy, &tensor.yy})
        one->reserve(values.size());
    for (std::size_t row = 0; row < rows; ++row) {
        ask_after(columns);
        const std::size_t above = row == 0 ? 0 : row - 1, below = std::min(row + 1, rows - 1);
        for (std::size_t column = 0; column < columns; ++column) {
            const std::size_t left = column == 0 ? 0 : column - 1;
            const std::size_t right = std::min(column + 1, columns - 1);
            const auto at = [&](std::size_t y, std::size_t x) { return values[y * columns + x]; };
            const double x = (at(above, right) - at(above, left) + at(below, right) -
                              at(below, left) + 2 * (at(row, right) - at(row, left))) /
                             8;
            const double y = (at(above, left) - at(below, left) + at(above, right) -
                              at(below, right) + 2 * (at(above, column) - at(below, column))) /
                             8;
            tensor.xx.push_back(x * x);
            tensor.xy.push_back(x * y);
            tensor.yy.push_back(y * y);
        }
    }
    return tensor;
}

}  // namespace

std::vector<Stretch> stretches_along(std::span<const double> darkness, std::size_t columns,
                                     std::size_t rows, double ratio) {
    Tensor tensor = products_of_gradients(darkness, columns, rows);
    const std::size_t radius = std::max<std::size_t>(1, std::min(columns, rows) / kPartOfSide);
    for (std::vector<double>* const one : {&tensor.xx, &tensor.xy, &tensor.yy})
        blur(*one, columns, rows, radius);
    std::vector<Stretch> stretches;
    stretches.reserve(darkness.size());
    for_each_polled(darkness.size(), ask, [&](std::size_t i) {
        const double difference = tensor.xx[i] - tensor.yy[i];
        const double twice = 2 * tensor.xy[i];
        // The difference of the eigenvalues over their sum: 1 if all gradients have one direction.
        const double coherence = std::sqrt(difference * difference + twice * twice) /
                                 (tensor.xx[i] + tensor.yy[i] + kNoise);
        const double across = angle_of(difference, twice) / 2;
        stretches.push_back(
            {1 / power(1 / ratio, std::min(coherence, 1.0)), across + std::numbers::pi / 2});
    });
    return stretches;
}

}  // namespace lacuna::pictures
