// Distances from a tree of edges.
#include "verify/outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace lacuna::verify {
namespace {

constexpr double kNoEdge = std::numeric_limits<double>::infinity();

std::array<Point, 4> corners_of(const Cell& cell) {
    return {Point{cell.left, cell.bottom}, Point{cell.right, cell.bottom},
            Point{cell.left, cell.top}, Point{cell.right, cell.top}};
}

// Whether the line from one point to another meets the cell, including its sides.
bool is_met_by(const Cell& cell, Point from, Point to) {
    double begin = 0;
    double end = 1;
    const auto cut = [&](double at, double step, double low, double high) {
        if (step == 0) return at >= low && at <= high;
        const double into = ((step > 0 ? low : high) - at) / step;
        const double out = ((step > 0 ? high : low) - at) / step;
        begin = std::max(begin, into);
        end = std::min(end, out);
        return begin <= end;
    };
    return cut(from.x, to.x - from.x, cell.left, cell.right) &&
           cut(from.y, to.y - from.y, cell.bottom, cell.top);
}

}  // namespace

Outline::Outline(std::span<const std::vector<Point>> rings)
    : edges_(edges_of(rings)), tree_(edges_, around_edge) {}

std::vector<Outline::Edge> Outline::edges_of(std::span<const std::vector<Point>> rings) {
    std::vector<Edge> edges;
    for (const std::vector<Point>& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i)
            edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
    return edges;
}

Cell Outline::around_edge(const Edge& edge) {
    const auto [left, right] = std::minmax(edge.from.x, edge.to.x);
    const auto [bottom, top] = std::minmax(edge.from.y, edge.to.y);
    return {left, right, bottom, top};
}

double Outline::squared_distance(Point place, const Edge& edge) {
    const double dx = edge.to.x - edge.from.x;
    const double dy = edge.to.y - edge.from.y;
    const double length = square(dx) + square(dy);
    const double along = (place.x - edge.from.x) * dx + (place.y - edge.from.y) * dy;
    const double share = length > 0 ? std::clamp(along / length, 0.0, 1.0) : 0;
    return square(place.x - (edge.from.x + share * dx)) +
           square(place.y - (edge.from.y + share * dy));
}

double Outline::nearest(Point place) const {
    return std::sqrt(
        tree_.least([&](const Cell& around) { return squared_distance_to(around, place); },
                    [&](std::size_t i) { return squared_distance(place, edges_[i]); }));
}

double Outline::least_squared_distance(const Cell& cell) const {
    const auto to_edge = [&](std::size_t i) {
        const Edge& edge = edges_[i];
        if (is_met_by(cell, edge.from, edge.to)) return 0.0;
        double least =
            std::min(squared_distance_to(cell, edge.from), squared_distance_to(cell, edge.to));
        for (const Point corner : corners_of(cell))
            least = std::min(least, squared_distance(corner, edge));
        return least;
    };
    return tree_.least([&](const Cell& around) { return squared_distance_between(around, cell); },
                       to_edge);
}

// The place of a cell that is farthest from an edge, or from a rectangle, is a corner.
double Outline::least_of_farthest_squared(const Cell& cell) const {
    const auto most_of_corners = [&](auto to_corner) {
        double most = 0;
        for (const Point corner : corners_of(cell)) most = std::max(most, to_corner(corner));
        return most;
    };
    return tree_.least(
        [&](const Cell& around) {
            return most_of_corners([&](Point p) { return squared_distance_to(around, p); });
        },
        [&](std::size_t i) {
            return most_of_corners([&](Point p) { return squared_distance(p, edges_[i]); });
        });
}

// Counts the edges that a ray to the right crosses. The lower end of an edge belongs to it, the
// upper end does not.
bool Outline::is_inside(Point place) const {
    bool inside = false;
    tree_.visit(
        [&](const Cell& around) {
            return place.y >= around.bottom && place.y < around.top && place.x < around.right;
        },
        [&](std::size_t i) {
            const auto& [from, to] = edges_[i];
            if ((from.y > place.y) == (to.y > place.y)) return;
            const double x = from.x + (place.y - from.y) / (to.y - from.y) * (to.x - from.x);
            if (place.x < x) inside = !inside;
        });
    return inside;
}

// Suppose that a spot of the cell is deeper than the clearance, so that no edge is nearer to it.
// Then the inner cell, which is smaller by half of the clearance on each side, has a spot on that
// side of the edges. If no edge meets the inner cell, all of it lies on the same side as its
// centre.
Openness Outline::under(const Cell& cell, double clearance, Side side) const {
    if (edges_.empty()) return {side == Side::outside, side == Side::inside};
    const Frame frame(cell);
    const double depth = (side == Side::inside ? 1 : -1) * depth_of(frame.centre);
    const double half_diagonal = std::hypot(frame.half_width, frame.half_height);
    if (depth - half_diagonal > clearance) return {true, false};
    if (depth + half_diagonal <= clearance) return {false, true};
    if (depth <= 0) {
        const double x = std::min(clearance / 2, frame.half_width);
        const double y = std::min(clearance / 2, frame.half_height);
        // Rounding must not give a thin cell an inner cell of negative size: no edge would meet it.
        const Cell inner{
            std::min(cell.left + x, frame.centre.x), std::max(cell.right - x, frame.centre.x),
            std::min(cell.bottom + y, frame.centre.y), std::max(cell.top - y, frame.centre.y)};
        if (least_squared_distance(inner) > 0) return {false, true};
    }
    const double most = square(clearance);
    return {depth > clearance || least_of_farthest_squared(cell) > most,
            least_squared_distance(cell) <= most};
}

Openness Outline::within(const Cell& cell, double distance) const {
    if (edges_.empty() || distance <= 0) return {false, true};
    if (least_of_farthest_squared(cell) < square(distance)) return {true, false};
    return {least_squared_distance(cell) < square(distance), true};
}

double Outline::depth_of(Point place) const {
    if (edges_.empty()) return -kNoEdge;
    return is_inside(place) ? nearest(place) : -nearest(place);
}

}  // namespace lacuna::verify
