// The checks of pairs and lattice points, by brute force and by a grid.
#include "cells/check.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lacuna::tests {
namespace {

// Radii are rounded up to 1/256 of a lattice step, by at least 2^-10 of that.
constexpr double kRounding = 1.002 / 256;

std::int64_t wrapped(std::int64_t at, std::int64_t count) {
    return (at % count + count) % count;
}

}  // namespace

// Points in square buckets of lattice points, to find all points within some steps.
class CellsCheck::Buckets {
public:
    Buckets(const CellsCheck& check, std::int64_t side)
        : check_(check),
          side_(side),
          across_((check.columns_ + side - 1) / side),
          up_((check.rows_ + side - 1) / side),
          buckets_(static_cast<std::size_t>(across_ * up_)) {
        for (std::size_t i = 0; i < check.places_.size(); ++i)
            bucket(check.places_[i].x / side, check.places_[i].y / side).push_back(i);
    }

    // Whether `is_it` holds for some point in the buckets within `steps` of the lattice point.
    template <typename Is>
    bool any_near(Place place, double steps, Is is_it) {
        const auto [left, right] = stretch(place.x, steps, check_.columns_, across_);
        const auto [low, high] = stretch(place.y, steps, check_.rows_, up_);
        for (std::int64_t i = left; i <= right; ++i)
            for (std::int64_t j = low; j <= high; ++j)
                for (const std::size_t point : bucket(wrapped(i, across_), wrapped(j, up_)))
                    if (is_it(point)) return true;
        return false;
    }

private:
    std::vector<std::size_t>& bucket(std::int64_t i, std::int64_t j) {
        return buckets_[static_cast<std::size_t>(i * up_ + j)];
    }
    // On the torus it goes past both ends, because the last bucket is shorter; at most all buckets.
    std::pair<std::int64_t, std::int64_t> stretch(std::int64_t at, double steps,
                                                  std::int64_t length, std::int64_t count) const {
        const bool wraps = check_.request_.domain.wraps();
        if (2 * steps + 3 * static_cast<double>(side_) >= static_cast<double>(length))
            return {0, count - 1};
        const auto reach = static_cast<std::int64_t>(steps) + 1;
        std::int64_t low = (at - reach) / side_;
        std::int64_t high = (at + reach) / side_;
        if (wraps && at < reach) low = (at - reach + length) / side_ - count;
        if (wraps && at + reach >= length) high = (at + reach - length) / side_ + count;
        if (wraps) return {low, high};
        return {std::max<std::int64_t>(low, 0), std::min(high, count - 1)};
    }

    const CellsCheck& check_;
    std::int64_t side_;
    std::int64_t across_;
    std::int64_t up_;
    std::vector<std::vector<std::size_t>> buckets_;
};

CellsCheck::CellsCheck(const Request& request, std::vector<Point> points)
    : request_(request), points_(std::move(points)) {
    const std::vector<double>& importance = request.field->importance;
    least_radius_ =
        *request.scale / std::sqrt(*std::max_element(importance.begin(), importance.end()));
    const double across =
        std::ceil(*request.paper2011.lines_per_radius * request.domain.width / least_radius_);
    columns_ = std::max(static_cast<std::int64_t>(across), std::int64_t{1});
    const double up = static_cast<double>(columns_) * request.domain.height / request.domain.width;
    rows_ = std::max(std::llround(up), 1LL);
    // Steps along y that are over 1 % shorter than those along x make these shorter, too.
    if (static_cast<double>(rows_) > 1.01 * up)
        columns_ =
            std::llround(static_cast<double>(rows_) * request.domain.width / request.domain.height);
    step_ = std::min(request.domain.width / static_cast<double>(columns_),
                     request.domain.height / static_cast<double>(rows_));
    for (const Point point : points_) places_.push_back(place_of(point));
}

CellsCheck::Place CellsCheck::place_of(Point point) const {
    return {std::llround(point.x / request_.domain.width * static_cast<double>(columns_) - 0.5),
            std::llround(point.y / request_.domain.height * static_cast<double>(rows_) - 0.5)};
}

// The pixel under the middle of the cell; row 0 of the field is the top. On the border between two
// pixels it is the right one, or the upper one.
std::size_t CellsCheck::pixel_of(Place place) const {
    const std::int64_t columns = request_.field->columns;
    const std::int64_t rows = request_.field->rows;
    const std::int64_t column = (2 * place.x + 1) * columns / (2 * columns_);
    const std::int64_t row_from_below = (2 * place.y + 1) * rows / (2 * rows_);
    return static_cast<std::size_t>((rows - 1 - row_from_below) * columns + column);
}

double CellsCheck::radius_at(Place place) const {
    return *request_.scale / std::sqrt(request_.field->importance[pixel_of(place)]);
}

double CellsCheck::metric_of(double a, double b) const {
    switch (request_.metric) {
        case Metric::min:
            return std::min(a, b);
        case Metric::mean:
            return (a + b) / 2;
        default:
            return std::max(a, b);
    }
}

double CellsCheck::distance(Point a, Point b) const {
    const bool wraps = request_.domain.wraps();
    double dx = std::abs(a.x - b.x);
    double dy = std::abs(a.y - b.y);
    if (wraps) dx = std::min(dx, request_.domain.width - dx);
    if (wraps) dy = std::min(dy, request_.domain.height - dy);
    return std::sqrt(dx * dx + dy * dy);
}

testing::AssertionResult CellsCheck::is_on_the_lattice() const {
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const Point point = points_[i];
        const Place place = places_[i];
        const double x = point.x / request_.domain.width * static_cast<double>(columns_);
        const double y = point.y / request_.domain.height * static_cast<double>(rows_);
        const bool is_inside =
            place.x >= 0 && place.x < columns_ && place.y >= 0 && place.y < rows_;
        if (!is_inside || std::abs(x - 0.5 - static_cast<double>(place.x)) > 1e-9 ||
            std::abs(y - 0.5 - static_cast<double>(place.y)) > 1e-9)
            return testing::AssertionFailure()
                   << "point " << i << " is not in the middle of a cell: " << x << ", " << y
                   << " steps of " << columns_ << " x " << rows_;
        if (request_.field->importance[pixel_of(place)] <= 0)
            return testing::AssertionFailure() << "point " << i << " lies on a white pixel";
    }
    return testing::AssertionSuccess();
}

testing::AssertionResult CellsCheck::check_pair(std::size_t i, std::size_t j) const {
    const double wanted = metric_of(radius_at(places_[i]), radius_at(places_[j]));
    const double got = distance(points_[i], points_[j]);
    if (got >= wanted) return testing::AssertionSuccess();
    return testing::AssertionFailure()
           << "points " << i << " and " << j << " are " << got << " apart, closer than " << wanted;
}

testing::AssertionResult CellsCheck::keeps_its_distances(By by) const {
    testing::AssertionResult result = testing::AssertionSuccess();
    if (by == By::brute_force) {
        for (std::size_t i = 0; i < points_.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                if (result = check_pair(i, j); !result) return result;
        return result;
    }
    // The metric's radius is at most the larger radius, so looking around that point finds a pair.
    Buckets buckets(*this, *request_.paper2011.lines_per_radius);
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const auto is_too_close = [&](std::size_t j) {
            return i != j && !(result = check_pair(i, j));
        };
        if (buckets.any_near(places_[i], radius_at(places_[i]) / step_, is_too_close))
            return result;
    }
    return result;
}

bool CellsCheck::blocks(Place sample, Place other) const {
    const auto along = [&](std::int64_t a, std::int64_t b, std::int64_t count) {
        const std::int64_t straight = std::abs(a - b);
        return static_cast<double>(request_.domain.wraps() ? std::min(straight, count - straight)
                                                           : straight);
    };
    const double reach = metric_of(radius_at(sample), radius_at(other)) / step_ + kRounding;
    const double dx = along(sample.x, other.x, columns_);
    const double dy = along(sample.y, other.y, rows_);
    return dx * dx + dy * dy < reach * reach;
}

testing::AssertionResult CellsCheck::not_blocked(Place place) const {
    return testing::AssertionFailure() << "lattice point (" << place.x << ", " << place.y << ") of "
                                       << columns_ << " x " << rows_ << " is free";
}

// The lattice points that each point blocks in its own disk: all with min, some with mean and max.
std::vector<bool> CellsCheck::blocked_within_own_radius() const {
    const bool wraps = request_.domain.wraps();
    std::vector<bool> blocked(static_cast<std::size_t>(columns_ * rows_), false);
    for (const Place sample : places_) {
        const double radius = radius_at(sample) / step_ + 1;
        const auto reach =
            static_cast<std::int64_t>(std::min(radius, static_cast<double>(columns_ + rows_)));
        const std::int64_t across = std::min(reach, wraps ? columns_ / 2 + 1 : columns_);
        const std::int64_t up = std::min(reach, wraps ? rows_ / 2 + 1 : rows_);
        for (std::int64_t i = sample.x - across; i <= sample.x + across; ++i) {
            if (!wraps && (i < 0 || i >= columns_)) continue;
            for (std::int64_t j = sample.y - up; j <= sample.y + up; ++j) {
                if (!wraps && (j < 0 || j >= rows_)) continue;
                const Place other = {wrapped(i, columns_), wrapped(j, rows_)};
                const auto index = static_cast<std::size_t>(other.x * rows_ + other.y);
                if (!blocked[index] && blocks(sample, other)) blocked[index] = true;
            }
        }
    }
    return blocked;
}

bool CellsCheck::is_blocked_by_any(Place place) const {
    return std::any_of(places_.begin(), places_.end(),
                       [&](Place sample) { return blocks(sample, place); });
}

testing::AssertionResult CellsCheck::is_maximal(By by) const {
    std::vector<bool> blocked;
    if (by == By::grid) blocked = blocked_within_own_radius();
    Buckets buckets(*this, *request_.paper2011.lines_per_radius);
    for (std::int64_t x = 0; x < columns_; ++x) {
        for (std::int64_t y = 0; y < rows_; ++y) {
            const Place place = {x, y};
            if (request_.field->importance[pixel_of(place)] <= 0) continue;
            if (by == By::brute_force) {
                if (!is_blocked_by_any(place)) return not_blocked(place);
                continue;
            }
            if (blocked[static_cast<std::size_t>(x * rows_ + y)]) continue;
            // A point of smaller radius that blocks it is within this lattice point's own radius.
            const auto is_near = [&](std::size_t i) { return blocks(places_[i], place); };
            if (!buckets.any_near(place, radius_at(place) / step_ + 1, is_near))
                return not_blocked(place);
        }
    }
    return testing::AssertionSuccess();
}

}  // namespace lacuna::tests
