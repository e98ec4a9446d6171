// Ways, distances, pixels and polygons, from their definitions.
#include "judge/plane.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace lacuna::judge {
namespace {

bool is_torus(const Domain& domain) {
    return domain.boundary == Boundary::torus;
}

double way_along(bool wraps, double from, double to, double side) {
    const double straight = to - from;
    if (!wraps || std::abs(straight) <= side - std::abs(straight)) return straight;
    return straight > 0 ? straight - side : straight + side;
}

// Around a torus this is no difference of coordinates plus a side, which would be rounded twice.
double along(bool wraps, double a, double b, double side) {
    const double straight = std::abs(a - b);
    return wraps ? std::min(straight, side - straight) : straight;
}

double distance_to_edge(Point at, Point a, Point b) {
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double share = ((at.x - a.x) * dx + (at.y - a.y) * dy) / (dx * dx + dy * dy);
    const double on = std::isnan(share) ? 0 : std::clamp(share, 0.0, 1.0);
    return std::hypot(at.x - a.x - on * dx, at.y - a.y - on * dy);
}

// The distance of neighbours in a hexagonal lattice.
double of_hexagons(const Domain& domain, std::size_t points) {
    const double area = domain.width * domain.height / static_cast<double>(points);
    return std::sqrt(2 / std::sqrt(3.0) * area);
}

}  // namespace

Point way(const Domain& domain, Point from, Point to) {
    return {way_along(is_torus(domain), from.x, to.x, domain.width),
            way_along(is_torus(domain), from.y, to.y, domain.height)};
}

double distance(const Domain& domain, Point a, Point b) {
    const double dx = along(is_torus(domain), a.x, b.x, domain.width);
    const double dy = along(is_torus(domain), a.y, b.y, domain.height);
    return std::sqrt(dx * dx + dy * dy);
}

double distance_to_nearest(const Domain& domain, std::span<const Point> points, Point at) {
    double least = kInfinity;
    for (const Point& point : points) least = std::min(least, distance(domain, at, point));
    return least;
}

Pair closest_pair(const Domain& domain, std::span<const Point> points) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](auto a, auto b) { return points[a].x < points[b].x; });
    const std::size_t n = order.size();
    Pair closest;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t step = 1; step < n; ++step) {
            const std::size_t j = i + step;
            if (j >= n && !is_torus(domain)) break;
            const Point from = points[order[i]], to = points[order[j % n]];
            const double ahead = to.x - from.x + (j < n ? 0 : domain.width);
            if (ahead * (1 - 1e-9) > closest.distance) break;
            const auto [first, second] = std::minmax(order[i], order[j % n]);
            const Pair pair{first, second, distance(domain, from, to)};
            const bool is_before =
                first < closest.first || (first == closest.first && second < closest.second);
            if (pair.distance < closest.distance ||
                (pair.distance == closest.distance && is_before))
                closest = pair;
        }
    return closest;
}

double relative_distance(const Domain& domain, std::span<const Point> points) {
    return closest_pair(domain, points).distance / of_hexagons(domain, points.size());
}

std::vector<double> relative_distances(const Domain& domain, std::span<const Point> points) {
    std::vector<double> relative;
    double least = kInfinity;
    for (std::size_t i = 1; i < points.size(); ++i) {
        least = std::min(least, distance_to_nearest(domain, points.first(i), points[i]));
        relative.push_back(least / of_hexagons(domain, i + 1));
    }
    return relative;
}

Point wrapped(const Domain& domain, Point at) {
    if (!is_torus(domain)) return at;
    const auto within = [](double low, double side, double coordinate) {
        const double there = coordinate - side * std::floor((coordinate - low) / side);
        return there >= low && there < low + side ? there : low;
    };
    return {within(domain.x0, domain.width, at.x), within(domain.y0, domain.height, at.y)};
}

bool contains(const Domain& domain, Point at, bool is_open) {
    const double right = domain.x0 + domain.width, top = domain.y0 + domain.height;
    if (!(at.x >= domain.x0 && at.x <= right && at.y >= domain.y0 && at.y <= top)) return false;
    return !(is_open || is_torus(domain)) || (at.x < right && at.y < top);
}

double to_edges(const Domain& domain, Point at) {
    // The upper edges are sums of the corner and the sides, as in Domain::holds.
    return std::min({at.x - domain.x0, domain.x0 + domain.width - at.x, at.y - domain.y0,
                     domain.y0 + domain.height - at.y});
}

std::size_t pixel_of(const Domain& domain, std::uint32_t columns, std::uint32_t rows, Point at) {
    const auto index = [](double share, std::uint32_t count) {
        return static_cast<std::size_t>(std::clamp(std::floor(share * count), 0.0, count - 1.0));
    };
    const std::size_t row = rows - 1 - index((at.y - domain.y0) / domain.height, rows);
    return row * columns + index((at.x - domain.x0) / domain.width, columns);
}

double depth_in(std::span<const PolygonRing> rings, Point at) {
    double least = kInfinity;
    bool is_inside = false;
    for (const PolygonRing& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point a = ring[i], b = ring[(i + 1) % ring.size()];
            least = std::min(least, distance_to_edge(at, a, b));
            if ((a.y > at.y) != (b.y > at.y) &&
                at.x < a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x))
                is_inside = !is_inside;
        }
    return is_inside ? least : -least;
}

double depth_in(std::span<const PolygonSet> sets, Point at) {
    double in_any = -kInfinity, near_any = -kInfinity, depth = kInfinity;
    bool has_inside = false, has_near = false;
    for (const PolygonSet& set : sets) {
        const double own = depth_in(set.rings, at);
        const bool forbidden = is_forbidden(set.role);
        if (set.role == Role::near) {
            has_near = true;
            near_any = std::max(near_any, set.distance - std::abs(own));
            continue;
        }
        if (forbidden) depth = std::min(depth, -own);
        if (forbidden && set.distance > 0) depth = std::min(depth, std::abs(own) - set.distance);
        if (forbidden) continue;
        has_inside = true;
        in_any = std::max(in_any, own - set.distance);
    }
    if (has_inside) depth = std::min(depth, in_any);
    return has_near ? std::min(depth, near_any) : depth;
}

std::string text_of(Point at) {
    std::ostringstream out;
    out.precision(17);
    out << "(" << at.x << ", " << at.y << ")";
    return out.str();
}

}  // namespace lacuna::judge
