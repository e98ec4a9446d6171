// Makes dots for an image, and compares tones by counting dots in squares.
#include "reproduce/stipple.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace lacuna::reproduce {

Sets stipple(const Field& image, std::uint64_t dots, Metric metric, Work& work, double cost) {
    Request request;
    request.mode = Mode::cells;
    request.field = &image;
    request.domain = domain_like(image.columns, image.rows);
    request.count = dots;
    request.metric = metric;
    request.paper2011.lines_per_radius = 30;
    request.run_on.backend = "cpu";
    return make_sets(request, 1, work, cost);
}

double tone_error(const Field& image, std::span<const Point> dots, std::uint32_t across) {
    const Domain domain = domain_like(image.columns, image.rows);
    std::vector<double> shares(std::size_t{across} * across);
    // Squares outside the domain stay 0 and add nothing.
    const auto add = [&](double x, double y, double share) {
        const auto square = [&](double at) {
            return std::min(across - 1, static_cast<std::uint32_t>(at * across));
        };
        shares[std::size_t{square(y)} * across + square(x)] += share;
    };
    for (const Point& dot : dots) add(dot.x, dot.y, 1 / static_cast<double>(dots.size()));
    const double all = std::accumulate(image.importance.begin(), image.importance.end(), 0.0);
    for (std::uint32_t row = 0; row < image.rows; ++row)
        for (std::uint32_t column = 0; column < image.columns; ++column)
            add((column + 0.5) / image.columns * domain.width,
                (1 - (row + 0.5) / image.rows) * domain.height,
                -image.importance[std::size_t{row} * image.columns + column] / all);
    return std::accumulate(shares.begin(), shares.end(), 0.0,
                           [](double sum, double share) { return sum + std::abs(share); }) /
           2;
}

}  // namespace lacuna::reproduce
