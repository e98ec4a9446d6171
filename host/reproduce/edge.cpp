// Counts samples near the edge and far from it.
#include "reproduce/edge.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace lacuna::reproduce {
namespace {

constexpr double kContrast = 10;

Request request_of(const Step& step, Metric metric, const Field& field) {
    Request request;
    request.mode = Mode::cells;
    request.field = &field;
    request.domain.width = 2;
    request.domain.boundary = Boundary::torus;
    request.scale = step.dense_radius;
    request.paper2011.lines_per_radius = step.m;
    request.metric = metric;
    request.run_on.backend = "cpu";
    return request;
}

double missing(std::span<const Point> points, const Step& step) {
    const double radius = step.dense_radius;
    const double far = 4 * radius * std::sqrt(kContrast);  // beyond this the edge has no effect
    double near_edge = 0;
    double far_from_edge = 0;
    for (const Point& point : points) {
        if (point.x >= 1) continue;
        const double to_edge = std::min(point.x, 1 - point.x);
        if (to_edge < radius) ++near_edge;
        if (to_edge > far) ++far_from_edge;
    }
    const double density = far_from_edge / (1 - 2 * far);
    const double radii_of_edge = 2 / radius;
    return (density * 2 * radius - near_edge) / radii_of_edge;
}

Mean mean_of(const std::vector<double>& values) {
    const auto n = static_cast<double>(values.size());
    double sum = 0;
    double squares = 0;
    for (const double value : values) {
        sum += value;
        squares += value * value;
    }
    const double mean = sum / n;
    const double variance = n > 1 ? (squares - n * mean * mean) / (n - 1) : 0;
    return {mean, std::sqrt(std::max(0.0, variance) / n)};
}

}  // namespace

Mean missing_along_edge(const Step& step, Metric metric, std::uint32_t runs, Work& work) {
    const Field field{2, 1, {1, 1 / kContrast}};
    std::vector<double> all;
    for (const auto& points : make_sets(request_of(step, metric, field), runs, work).points)
        all.push_back(missing(points, step));
    return mean_of(all);
}

}  // namespace lacuna::reproduce
