// The progressive order of points that are there already.
#include <lacuna/order.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include "base/polling.h"
#include "base/power.h"
#include "checks/domain.h"
#include "checks/pixels.h"
#include "plan/checked_request.h"
#include "plan/kept.h"
#include "plan/radius_field.h"
#include "plan/sizes.h"
#include "rounds/random.h"
#include "sampling/progressive.h"

namespace lacuna {
namespace {

// Points by cell, about one a cell. Points are given as ways from the domain's corner.
class OrderedCells {
public:
    OrderedCells(std::span<const Point> points, const OrderOptions& options)
        : points_(points),
          options_(options),
          side_(side_of(points.size(), options)),
          columns_(cells_along(options.domain.width)),
          rows_(cells_along(options.domain.height)),
          begins_(std::size_t{columns_} * rows_ + 1),
          members_(points.size()) {
        for_each_polled(points.size(), ask,
                        [&](std::size_t i) { ++begins_[cell_of(points[i]) + 1]; });
        std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
        std::vector<std::uint32_t> next(begins_.begin(), begins_.end() - 1);
        for_each_polled(points.size(), ask, [&](std::size_t i) {
            members_[next[cell_of(points[i])]++] = static_cast<std::uint32_t>(i);
        });
    }

    // Calls visit(index, squared distance) for each point nearer than `reach`, perhaps twice where
    // a torus is narrow.
    template <class Visit>
    void for_each_near(Point from, double reach, Visit visit) const {
        for_each_cell(
            from.y, reach, options_.domain.height, rows_, [&](std::size_t row, double up) {
                for_each_cell(
                    from.x, reach, options_.domain.width, columns_,
                    [&](std::size_t column, double right) {
                        const std::size_t cell = row * columns_ + column;
                        ask_after(1 + begins_[cell + 1] - begins_[cell]);
                        for (std::uint32_t k = begins_[cell]; k < begins_[cell + 1]; ++k) {
                            const Point& point = points_[members_[k]];
                            const double dx = point.x + right - from.x, dy = point.y + up - from.y;
                            const double squared = dx * dx + dy * dy;
                            if (squared < reach * reach) visit(members_[k], squared);
                        }
                    });
            });
    }

private:
    static double side_of(std::size_t points, const OrderOptions& options) {
        return std::sqrt(options.domain.width * options.domain.height /
                         static_cast<double>(points));
    }
    std::uint32_t cells_along(double length) const {
        return static_cast<std::uint32_t>(std::clamp(std::floor(length / side_), 1.0, 0x1p16));
    }
    std::uint32_t cell_of(Point point) const {
        const auto along = [](double share, std::uint32_t cells) {
            return std::min(static_cast<std::uint32_t>(share * cells), cells - 1);
        };
        return along(point.y / options_.domain.height, rows_) * columns_ +
               along(point.x / options_.domain.width, columns_);
    }

    // Calls visit(cell, shift) for the cells within reach along an axis. On a torus `shift` moves
    // the cell's points beside the place from which they are seen. A cell comes several times if
    // reach is longer than half of the torus.
    template <class Visit>
    void for_each_cell(double at, double reach, double length, std::uint32_t cells,
                       Visit visit) const {
        const double scale = cells / length;
        const auto number = static_cast<std::int64_t>(cells);
        auto first = static_cast<std::int64_t>(std::floor((at - reach) * scale));
        auto last = static_cast<std::int64_t>(std::floor((at + reach) * scale));
        if (!options_.domain.wraps()) {
            first = std::max<std::int64_t>(first, 0);
            last = std::min(last, number - 1);
        }
        for (std::int64_t cell = first; cell <= last; ++cell) {
            const std::int64_t turns = cell >= 0 ? cell / number : -((number - 1 - cell) / number);
            visit(static_cast<std::size_t>(cell - turns * number),
                  static_cast<double>(turns) * length);
        }
    }

    std::span<const Point> points_;
    const OrderOptions& options_;
    double side_;
    std::uint32_t columns_;
    std::uint32_t rows_;
    std::vector<std::uint32_t> begins_;   // of each cell in members_
    std::vector<std::uint32_t> members_;  // indices of points, cell by cell
};

// All indices in an order of chance (Fisher & Yates 1938).
std::vector<std::uint32_t> shuffled(std::size_t count, std::uint64_t seed) {
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0U);
    for_each_polled(count, ask, [&](std::size_t k) {
        const std::size_t i = count - k;
        std::swap(order[i - 1], order[scaled(random_bits(seed, i).first, i)]);
    });
    return order;
}

// A request that keeps the points, with radii in units of the size. Checks both.
Request checked_request(std::span<const Point> points, const Field* field,
                        const OrderOptions& options) {
    Request request;
    request.domain = options.domain;
    request.field = field;
    request.count = 1;
    check_request(request);
    request.count.reset();
    (field != nullptr ? request.scale : request.radius) = 1;
    request.keep = points;
    for_each_polled(points.size(), ask,
                    [&](std::size_t i) { check_kept_place(request, i, "points"); });
    return request;
}

// The points that were taken, and how far the others are from them.
class Order {
public:
    Order(std::span<const Point> points, std::vector<double> radii, const OrderOptions& options)
        : points_(points),
          radii_(std::move(radii)),
          cells_(points, options),
          free_(points.size(), std::numeric_limits<double>::infinity()) {
        taken_.reserve(points.size());
    }

    // Takes each of the points that is at least `size` from all that are taken by then. Returns the
    // others.
    std::vector<std::uint32_t> take_level(const std::vector<std::uint32_t>& waiting, double size) {
        std::vector<std::uint32_t> others;
        for_each_polled(waiting.size(), ask, [&](std::size_t i) {
            if (free_[waiting[i]] >= size * size)
                take(waiting[i], size);
            else
                others.push_back(waiting[i]);
        });
        return others;
    }
    void take_all(const std::vector<std::uint32_t>& waiting) {
        taken_.insert(taken_.end(), waiting.begin(), waiting.end());
    }
    std::vector<std::uint32_t> taken() && { return std::move(taken_); }

private:
    void take(std::uint32_t index, double size) {
        taken_.push_back(index);
        const double radius = radii_[index];
        cells_.for_each_near(points_[index], size * radius,
                             [&](std::uint32_t near, double squared) {
                                 const double smaller = std::min(radius, radii_[near]);
                                 free_[near] = std::min(free_[near], squared / (smaller * smaller));
                             });
    }

    std::span<const Point> points_;
    std::vector<double> radii_;
    OrderedCells cells_;
    // The squared distance to the nearest point taken, in units of the smaller radius. It is
    // infinite for points that were farther than the size, and sizes only shrink.
    std::vector<double> free_;
    std::vector<std::uint32_t> taken_;
};

}  // namespace

std::vector<std::uint32_t> progressive_order(std::span<const Point> points, const Field* field,
                                             const OrderOptions& options) {
    const Request request = checked_request(points, field, options);
    const std::vector<Point> ways = from_corner(points, options.domain);
    if (field != nullptr) check_disks(*field, "orders");
    if (points.empty()) return {};
    const std::vector<double> radii = radii_of_kept(request);
    const double smallest = kSmallestRadius * options.domain.longer_side() /
                            *std::max_element(radii.begin(), radii.end());
    Order order(ways, radii, options);
    std::vector<std::uint32_t> waiting = shuffled(points.size(), options.seed);
    const double first = radius_field_scale_for_count(request, kFirstPoints, ask);
    double size = first;
    for (int level = 1; !waiting.empty() && size > smallest; ++level) {
        waiting = order.take_level(waiting, size);
        size = first * power(0.5, static_cast<double>(level) / kLevelsPerHalving);
    }
    order.take_all(waiting);  // points on the same place
    return std::move(order).taken();
}

}  // namespace lacuna
