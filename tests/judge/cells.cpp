// The checks of the lattice, pairs and lattice points of mode cells.
#include "judge/cells.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "judge/plane.h"

namespace lacuna::judge {
namespace {

// Radii are rounded up to 1/256 of a lattice step, by at least 2^-10 of that.
constexpr double kRounding = 1.002 / 256;

std::int64_t wrapped(std::int64_t at, std::int64_t count) {
    return (at % count + count) % count;
}

}  // namespace

CellsJudge::CellsJudge(const Request& request, std::span<const Point> points)
    : request_(request), points_(points.begin(), points.end()) {
    const Domain& domain = request.domain;
    const std::vector<double>& importance = request.field->importance;
    const double least =
        *request.scale / std::sqrt(*std::max_element(importance.begin(), importance.end()));
    side_ = *request.paper2011.lines_per_radius;
    columns_ = std::max<std::int64_t>(
        std::llround(std::ceil(static_cast<double>(side_) * domain.width / least)), 1);
    const double up = static_cast<double>(columns_) * domain.height / domain.width;
    rows_ = std::max(std::llround(up), 1LL);
    // Steps along y that are over 1 % shorter than those along x make these shorter, too.
    if (static_cast<double>(rows_) > 1.01 * up)
        columns_ = std::llround(static_cast<double>(rows_) * domain.width / domain.height);
    step_ = std::min(domain.width / static_cast<double>(columns_),
                     domain.height / static_cast<double>(rows_));
    across_ = (columns_ + side_ - 1) / side_;
    up_ = (rows_ + side_ - 1) / side_;
    squares_.resize(static_cast<std::size_t>(across_ * up_));
    for (const Point point : points_) places_.push_back(place_of(point));
    for (std::size_t i = 0; i < places_.size(); ++i) {
        const Place in{std::clamp<std::int64_t>(places_[i].x, 0, columns_ - 1) / side_,
                       std::clamp<std::int64_t>(places_[i].y, 0, rows_ - 1) / side_};
        squares_[static_cast<std::size_t>(in.x * up_ + in.y)].push_back(i);
    }
}

CellsJudge::Place CellsJudge::place_of(Point point) const {
    const Domain& domain = request_.domain;
    const double x = (point.x - domain.x0) / domain.width * static_cast<double>(columns_);
    const double y = (point.y - domain.y0) / domain.height * static_cast<double>(rows_);
    return {std::llround(x - 0.5), std::llround(y - 0.5)};
}

// The pixel under the middle of the cell, on the border between two pixels the right or upper one.
std::size_t CellsJudge::pixel_of(Place place) const {
    const std::int64_t columns = request_.field->columns, rows = request_.field->rows;
    const std::int64_t column = (2 * place.x + 1) * columns / (2 * columns_);
    const std::int64_t row_from_below = (2 * place.y + 1) * rows / (2 * rows_);
    return static_cast<std::size_t>((rows - 1 - row_from_below) * columns + column);
}

double CellsJudge::radius_at(Place place) const {
    return *request_.scale / std::sqrt(request_.field->importance[pixel_of(place)]);
}

double CellsJudge::metric_of(double a, double b) const {
    if (request_.metric == Metric::mean) return (a + b) / 2;
    return request_.metric == Metric::min ? std::min(a, b) : std::max(a, b);
}

// Whether `is_it` holds for some point in the squares within `steps` of the lattice point.
bool CellsJudge::any_near(Place place, double steps, const Is& is_it) const {
    const bool wraps = request_.domain.boundary == Boundary::torus;
    // On the torus it goes past both ends, because the last square is shorter; at most all squares.
    const auto stretch = [&](std::int64_t at, std::int64_t length, std::int64_t count) {
        if (2 * steps + 3 * static_cast<double>(side_) >= static_cast<double>(length))
            return std::pair<std::int64_t, std::int64_t>{0, count - 1};
        const auto reach = static_cast<std::int64_t>(steps) + 1;
        std::int64_t low = (at - reach) / side_, high = (at + reach) / side_;
        if (wraps && at < reach) low = (at - reach + length) / side_ - count;
        if (wraps && at + reach >= length) high = (at + reach - length) / side_ + count;
        if (!wraps) low = std::max<std::int64_t>(low, 0), high = std::min(high, count - 1);
        return std::pair{low, high};
    };
    const auto [left, right] = stretch(place.x, columns_, across_);
    const auto [low, high] = stretch(place.y, rows_, up_);
    for (std::int64_t i = left; i <= right; ++i)
        for (std::int64_t j = low; j <= high; ++j) {
            const std::int64_t square = wrapped(i, across_) * up_ + wrapped(j, up_);
            for (const std::size_t point : squares_[static_cast<std::size_t>(square)])
                if (is_it(point)) return true;
        }
    return false;
}

std::string CellsJudge::fault() const {
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const Place at = places_[i];
        const Domain& domain = request_.domain;
        const Point middle{domain.x0 + (static_cast<double>(at.x) + 0.5) * domain.width /
                                           static_cast<double>(columns_),
                           domain.y0 + (static_cast<double>(at.y) + 0.5) * domain.height /
                                           static_cast<double>(rows_)};
        const bool is_inside = at.x >= 0 && at.x < columns_ && at.y >= 0 && at.y < rows_;
        const double most = 1e-9 * step_ + (std::abs(middle.x) + std::abs(middle.y)) * 0x1p-52;
        if (!is_inside || std::abs(points_[i].x - middle.x) > most ||
            std::abs(points_[i].y - middle.y) > most)
            return "point " + std::to_string(i) + " at " + text_of(points_[i]) +
                   " is not in the middle of a cell of " + std::to_string(columns_) + " x " +
                   std::to_string(rows_);
        if (request_.field->importance[pixel_of(at)] <= 0)
            return "point " + std::to_string(i) + " lies on a white pixel";
    }
    // The metric's radius is at most the larger radius, so looking around that point finds a pair.
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const double own = radius_at(places_[i]);
        std::string found;
        any_near(places_[i], own / step_, [&](std::size_t j) {
            const double limit = metric_of(own, radius_at(places_[j]));
            if (i == j || distance(request_.domain, points_[i], points_[j]) >= limit) return false;
            found = "points " + std::to_string(i) + " and " + std::to_string(j) + " are too close";
            return true;
        });
        if (!found.empty()) return found;
    }
    return "";
}

bool CellsJudge::blocks(Place sample, Place other) const {
    const auto along = [&](std::int64_t a, std::int64_t b, std::int64_t count) {
        const std::int64_t straight = std::abs(a - b);
        const bool wraps = request_.domain.boundary == Boundary::torus;
        return static_cast<double>(wraps ? std::min(straight, count - straight) : straight);
    };
    const double reach = metric_of(radius_at(sample), radius_at(other)) / step_ + kRounding;
    const double dx = along(sample.x, other.x, columns_), dy = along(sample.y, other.y, rows_);
    return dx * dx + dy * dy < reach * reach;
}

// The lattice points that each point blocks in its own disk: all with min, some with mean and max.
std::vector<bool> CellsJudge::blocked_within_own_radius() const {
    const bool wraps = request_.domain.boundary == Boundary::torus;
    std::vector<bool> blocked(static_cast<std::size_t>(columns_ * rows_), false);
    for (const Place sample : places_) {
        const double radius = radius_at(sample) / step_ + 1;
        const auto reach =
            static_cast<std::int64_t>(std::min(radius, static_cast<double>(columns_ + rows_)));
        const std::int64_t across = std::min(reach, wraps ? columns_ / 2 + 1 : columns_);
        const std::int64_t up = std::min(reach, wraps ? rows_ / 2 + 1 : rows_);
        for (std::int64_t i = sample.x - across; i <= sample.x + across; ++i)
            for (std::int64_t j = sample.y - up; j <= sample.y + up; ++j) {
                if (!wraps && (i < 0 || i >= columns_ || j < 0 || j >= rows_)) continue;
                const Place other = {wrapped(i, columns_), wrapped(j, rows_)};
                const auto index = static_cast<std::size_t>(other.x * rows_ + other.y);
                if (!blocked[index] && blocks(sample, other)) blocked[index] = true;
            }
    }
    return blocked;
}

std::string CellsJudge::room() const {
    const std::vector<bool> blocked = blocked_within_own_radius();
    for (std::int64_t x = 0; x < columns_; ++x)
        for (std::int64_t y = 0; y < rows_; ++y) {
            const Place place = {x, y};
            if (request_.field->importance[pixel_of(place)] <= 0 ||
                blocked[static_cast<std::size_t>(x * rows_ + y)])
                continue;
            // A point of smaller radius that blocks it is within this lattice point's own radius.
            if (!any_near(place, radius_at(place) / step_ + 1,
                          [&](std::size_t i) { return blocks(places_[i], place); }))
                return "lattice point (" + std::to_string(x) + ", " + std::to_string(y) + ") of " +
                       std::to_string(columns_) + " x " + std::to_string(rows_) + " is free";
        }
    return "";
}

}  // namespace lacuna::judge
