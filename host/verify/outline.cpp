// The tree of edges, which is built by halving the longer side of the rectangle around them.
#include "verify/outline.h"

#include <algorithm>
#include <array>
#include <bit>
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

double squared_distance_to(const Cell& cell, Point place) {
    const double dx = std::max({cell.left - place.x, 0.0, place.x - cell.right});
    const double dy = std::max({cell.bottom - place.y, 0.0, place.y - cell.top});
    return square(dx) + square(dy);
}

double squared_distance_between(const Cell& a, const Cell& b) {
    const double dx = std::max({a.left - b.right, 0.0, b.left - a.right});
    const double dy = std::max({a.bottom - b.top, 0.0, b.bottom - a.top});
    return square(dx) + square(dy);
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

// The nodes that are still to be visited. There are never more of them than the tree is deep.
class OpenNodes {
public:
    void push(std::size_t node) { nodes_[count_++] = node; }
    std::size_t pop() { return nodes_[--count_]; }
    bool is_empty() const { return count_ == 0; }

private:
    std::array<std::size_t, 128> nodes_;
    std::size_t count_ = 0;
};

}  // namespace

Outline::Outline(std::span<const std::vector<Point>> rings) {
    for (const std::vector<Point>& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i)
            edges_.push_back({ring[i], ring[(i + 1) % ring.size()]});
    if (edges_.empty()) return;
    // Each node halves its edges, so the depth of the tree is log2 of the number of leaves.
    const std::size_t leaves = std::bit_ceil((edges_.size() + kFewEdges - 1) / kFewEdges);
    nodes_.resize(4 * leaves);
    build(0, 0, edges_.size());
}

void Outline::build(std::size_t node, std::size_t begin, std::size_t end) {
    Cell around{kNoEdge, -kNoEdge, kNoEdge, -kNoEdge};
    for (std::size_t i = begin; i < end; ++i)
        for (const Point point : {edges_[i].from, edges_[i].to}) {
            around.left = std::min(around.left, point.x);
            around.right = std::max(around.right, point.x);
            around.bottom = std::min(around.bottom, point.y);
            around.top = std::max(around.top, point.y);
        }
    nodes_[node] = {around, begin, end};
    if (nodes_[node].is_leaf()) return;
    const bool is_wide = around.right - around.left >= around.top - around.bottom;
    const auto middle_of = [&](const Edge& edge) {
        return is_wide ? edge.from.x + edge.to.x : edge.from.y + edge.to.y;
    };
    const std::size_t half = begin + (end - begin + 1) / 2;
    const auto at = [&](std::size_t i) { return edges_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(half), at(end),
                     [&](const Edge& a, const Edge& b) { return middle_of(a) < middle_of(b); });
    build(2 * node + 1, begin, half);
    build(2 * node + 2, half, end);
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

template <typename ToNode, typename ToEdge>
double Outline::least(ToNode to_node, ToEdge to_edge) const {
    double least = kNoEdge;
    OpenNodes open;
    open.push(0);
    while (!open.is_empty()) {
        const std::size_t index = open.pop();
        const Node& node = nodes_[index];
        if (to_node(node.around) >= least) continue;
        if (node.is_leaf()) {
            for (std::size_t i = node.begin; i < node.end; ++i)
                least = std::min(least, to_edge(edges_[i]));
            continue;
        }
        const std::size_t low = 2 * index + 1;
        const std::size_t high = 2 * index + 2;
        const bool is_high_nearer = to_node(nodes_[high].around) < to_node(nodes_[low].around);
        // The nearer half is looked at first.
        open.push(is_high_nearer ? low : high);
        open.push(is_high_nearer ? high : low);
    }
    return least;
}

double Outline::nearest(Point place) const {
    return std::sqrt(least([&](const Cell& around) { return squared_distance_to(around, place); },
                           [&](const Edge& edge) { return squared_distance(place, edge); }));
}

double Outline::least_squared_distance(const Cell& cell) const {
    const auto to_edge = [&](const Edge& edge) {
        if (is_met_by(cell, edge.from, edge.to)) return 0.0;
        double least =
            std::min(squared_distance_to(cell, edge.from), squared_distance_to(cell, edge.to));
        for (const Point corner : corners_of(cell))
            least = std::min(least, squared_distance(corner, edge));
        return least;
    };
    return least([&](const Cell& around) { return squared_distance_between(around, cell); },
                 to_edge);
}

// The place of a cell that is farthest from an edge, or from a rectangle, is a corner.
double Outline::least_of_farthest_squared(const Cell& cell) const {
    const auto most_of_corners = [&](auto to_corner) {
        double most = 0;
        for (const Point corner : corners_of(cell)) most = std::max(most, to_corner(corner));
        return most;
    };
    return least(
        [&](const Cell& around) {
            return most_of_corners([&](Point p) { return squared_distance_to(around, p); });
        },
        [&](const Edge& edge) {
            return most_of_corners([&](Point p) { return squared_distance(p, edge); });
        });
}

// Counts the edges that a ray to the right crosses. The lower end of an edge belongs to it, the
// upper end does not.
bool Outline::is_inside(Point place) const {
    bool inside = false;
    OpenNodes open;
    open.push(0);
    while (!open.is_empty()) {
        const std::size_t index = open.pop();
        const Node& node = nodes_[index];
        if (place.y < node.around.bottom || place.y >= node.around.top ||
            place.x >= node.around.right)
            continue;
        if (!node.is_leaf()) {
            open.push(2 * index + 1);
            open.push(2 * index + 2);
            continue;
        }
        for (std::size_t i = node.begin; i < node.end; ++i) {
            const auto& [from, to] = edges_[i];
            if ((from.y > place.y) == (to.y > place.y)) continue;
            const double x = from.x + (place.y - from.y) / (to.y - from.y) * (to.x - from.x);
            if (place.x < x) inside = !inside;
        }
    }
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
