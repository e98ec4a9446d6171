// Points in the cells of a grid in space, to find those near a place.
#pragma once

#include <lacuna/space.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "verify/patience.h"
#include "verify/space/cells.h"

namespace lacuna::verify::space {

class PointsInSpace {
public:
    static constexpr double kFar = std::numeric_limits<double>::infinity();

    // The cells have this side, or a larger one if most would be empty. If the box wraps, each
    // point has images on all sides. Refers to the points and the patience.
    PointsInSpace(std::span<const Point3> points, const BoxCell& box, bool wraps, double side,
                  const Patience& patience)
        : points_(points), low_(box.low), patience_(patience) {
        for (const Point3& point : points) low_ = at_most(low_, point);
        Point3 high = box.high;
        for (const Point3& point : points)
            high = {std::max(high.x, point.x), std::max(high.y, point.y),
                    std::max(high.z, point.z)};
        const double extent = BoxCell{low_, high}.longest_side();
        // Not far under the distance of points, if these lie on a surface.
        const double least = extent / (2 * std::sqrt(static_cast<double>(points.size())) + 1);
        side_ = std::max({side, least, extent / static_cast<double>(kMostCells)});
        last_ = cell_of(high);
        if (wraps) period_ = box.high - box.low;
        for (std::size_t i = 0; i < points.size(); ++i)
            cells_.emplace_back(key_of(cell_of(points[i])), static_cast<std::uint32_t>(i));
        const auto less = [](const auto& a, const auto& b) { return a < b; };
        std::sort(cells_.begin(), cells_.end(), patience.looking(less));
    }

    double side() const { return side_; }

    // Calls `visit(number, position)` for each point within `reach` of a place in the box, and some
    // that are farther. On a torus the position is that of the image.
    template <class Visit>
    void for_each_near(const Point3& place, double reach, const Visit& visit) const {
        for (const Point3& shift : shifts_to(place, reach)) {
            const Point3 at = place - shift;
            const Point3 ball{reach, reach, reach};
            const Cell from = cell_of(at - ball), to = cell_of(at + ball);
            for (std::int64_t z = from[2]; z <= to[2]; ++z)
                for (std::int64_t y = from[1]; y <= to[1]; ++y) {
                    const auto first = std::lower_bound(cells_.begin(), cells_.end(),
                                                        std::pair{key_of({from[0], y, z}), 0U});
                    const std::uint64_t last = key_of({to[0], y, z});
                    for (auto it = first; it != cells_.end() && it->first <= last; ++it)
                        visit(std::size_t{it->second}, points_[it->second] + shift);
                }
        }
    }

    // There must be a point.
    double distance_to_nearest(const Point3& place) const {
        double nearest = kFar;
        for (double reach = side_; !(nearest <= reach); reach *= 2)
            for_each_near(place, reach, [&](std::size_t, const Point3& at) {
                nearest = std::min(nearest, distance_of(place, at));
            });
        return nearest;
    }
    // Calls `visit(position)` for each point that may be the nearest one to a spot within `radius`
    // of the place, and for some others. There must be a point.
    template <class Visit>
    void for_each_that_may_be_nearest(const Point3& place, double radius,
                                      const Visit& visit) const {
        for_each_near(place, distance_to_nearest(place) + 2 * radius,
                      [&](std::size_t, const Point3& at) { visit(at); });
    }

    struct Pair {
        std::size_t first = 0;
        std::size_t second = 0;
        double distance = kFar;
    };
    Pair closest_pair() const {
        Pair closest;
        if (points_.size() < 2) return closest;
        for (double reach = side_; !(closest.distance <= reach); reach *= 2)
            for (std::size_t i = 0; i < points_.size(); ++i) {
                if (i % kPointsPerLook == 0) patience_.look();
                const double most = std::min(reach, closest.distance);
                for_each_near(points_[i], most, [&](std::size_t k, const Point3& at) {
                    if (k <= i) return;
                    const double distance = distance_of(points_[i], at);
                    if (distance < closest.distance) closest = {i, k, distance};
                });
            }
        return closest;
    }

private:
    using Cell = std::array<std::int64_t, 3>;
    static constexpr std::int64_t kMostCells = 1 << 20;
    static constexpr std::size_t kPointsPerLook = 256;

    static Point3 at_most(const Point3& a, const Point3& b) {
        return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
    }
    Cell cell_of(const Point3& at) const {
        const auto along = [&](double coordinate, double low, std::int64_t last) {
            const double cell = std::floor((coordinate - low) / side_);
            return static_cast<std::int64_t>(std::clamp(cell, 0.0, static_cast<double>(last)));
        };
        return {along(at.x, low_.x, last_[0]), along(at.y, low_.y, last_[1]),
                along(at.z, low_.z, last_[2])};
    }
    static std::uint64_t key_of(const Cell& cell) {
        return static_cast<std::uint64_t>(cell[2] << 42 | cell[1] << 21 | cell[0]);
    }
    // From the points to their images that may lie within `reach` of the place.
    std::vector<Point3> shifts_to(const Point3& place, double reach) const {
        std::vector<Point3> shifts;
        const auto along = [&](double at, double low, double period) {
            const double first = std::ceil((at - reach - low - period) / period);
            const double last = std::floor((at + reach - low) / period);
            return std::pair{first * period, last * period};
        };
        if (period_ == Point3{}) return {{}};
        const auto x = along(place.x, low_.x, period_.x), y = along(place.y, low_.y, period_.y),
                   z = along(place.z, low_.z, period_.z);
        for (double a = x.first; a <= x.second; a += period_.x)
            for (double b = y.first; b <= y.second; b += period_.y)
                for (double c = z.first; c <= z.second; c += period_.z) shifts.push_back({a, b, c});
        return shifts;
    }

    std::span<const Point3> points_;
    Point3 low_;
    double side_ = 0;
    Cell last_{kMostCells, kMostCells, kMostCells};  // that holds a point, along each axis
    Point3 period_{};                                // 0 unless the box wraps
    const Patience& patience_;
    std::vector<std::pair<std::uint64_t, std::uint32_t>> cells_;
};

}  // namespace lacuna::verify::space
