// Bounds of the distance from a rectangle's spots to the nearest point, and the halving by them.
#include "verify/search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "verify/corners.h"

namespace lacuna::verify {
namespace {

// More neighbours than this, hardly fewer than those of the cell that was halved, are a crowd.
constexpr std::size_t kCrowd = 64;

// The half that is farther from the nearest point first: else a slope would be climbed in the
// smallest steps, each of them a new record.
std::pair<Cell, Cell> halves_of(const Cell& cell, const Frame& frame, Point nearest) {
    Cell low = cell;
    Cell high = cell;
    bool is_high_farther = false;
    if (frame.half_width >= frame.half_height) {
        low.right = high.left = frame.centre.x;
        is_high_farther = nearest.x < frame.centre.x;
    } else {
        low.top = high.bottom = frame.centre.y;
        is_high_farther = nearest.y < frame.centre.y;
    }
    return is_high_farther ? std::pair{high, low} : std::pair{low, high};
}

}  // namespace

Neighbours::Neighbours(const Domain& domain, std::span<const Point> points,
                       const Patience& patience)
    : domain_(domain), by_x_(points.begin(), points.end()) {
    std::sort(by_x_.begin(), by_x_.end(), patience.looking([](Point a, Point b) {
        return a.x != b.x ? a.x < b.x : a.y < b.y;
    }));
    by_x_.erase(std::unique(by_x_.begin(), by_x_.end()), by_x_.end());
}

void Neighbours::append_within(double reach, const Cell& cell, std::vector<Point>& found) const {
    const auto is_left_of = [](Point p, double x) { return p.x < x; };
    const int wraps = domain_.torus ? 1 : 0;
    for (int i = -wraps; i <= wraps; ++i) {
        const double shift_x = i * domain_.width;
        auto point =
            std::lower_bound(by_x_.begin(), by_x_.end(), cell.left - reach - shift_x, is_left_of);
        for (; point != by_x_.end() && point->x <= cell.right + reach - shift_x; ++point) {
            for (int j = -wraps; j <= wraps; ++j) {
                const double y = point->y + j * domain_.height;
                if (y >= cell.bottom - reach && y <= cell.top + reach)
                    found.push_back({point->x + shift_x, y});
            }
        }
    }
}

std::vector<Point> Neighbours::of(const Cell& cell) const {
    const Frame frame(cell);
    std::vector<Point> found;
    for (double reach = 2 * std::hypot(frame.half_width, frame.half_height);; reach *= 2) {
        found.clear();
        append_within(reach, cell, found);
        double farthest = std::numeric_limits<double>::infinity();
        for (const Point& p : found) farthest = std::min(farthest, frame.to_farthest(p));
        // One point within that of every spot: those out of reach are farther from all of them.
        const double needed = std::sqrt(farthest) + 2 * domain_.rounding();
        if (needed > reach) continue;
        std::erase_if(found, [&](Point p) { return frame.to_nearest(p) > square(needed); });
        return found;
    }
}

Spot Search::run(const Cell& cell, std::vector<Point> neighbours) {
    stack_ = std::move(neighbours);
    visit(cell, 0);
    return emptiest_;
}

void Search::visit(const Cell& cell, std::size_t begin) {
    constexpr std::uint32_t kSeldom = 1U << 10U;
    if (++visits_ % kSeldom == 0) patience_.look();
    const Frame frame(cell);
    const std::size_t end = stack_.size();
    const double settled = square(settled_from() - rounding_);
    double to_farthest = std::numeric_limits<double>::infinity();
    for (std::size_t i = begin; i < end; ++i) {
        to_farthest = std::min(to_farthest, frame.to_farthest(stack_[i]));
        if (to_farthest <= settled) return;
    }
    const std::size_t nearest = look_from_centre(frame.centre, begin);
    // First, as it is likely to cover a half.
    std::swap(stack_[begin], stack_[nearest]);
    const Point near = stack_[begin];

    const double needed = square(std::sqrt(to_farthest) + rounding_);
    stack_.resize(end + (end - begin));
    std::size_t top = end;
    for (std::size_t i = begin; i < end; ++i) {
        stack_[top] = stack_[i];
        if (frame.to_nearest(stack_[i]) <= needed) ++top;
    }
    stack_.resize(top);
    if (top - end > kCrowd && 8 * (top - end) > 7 * (end - begin)) thin_out(cell, end);
    top = stack_.size();
    const auto [first, second] = halves_of(cell, frame, near);
    visit(first, end);
    stack_.resize(top);
    visit(second, end);
}

std::size_t Search::look_from_centre(Point centre, std::size_t begin) {
    std::size_t nearest = begin;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = begin; i < stack_.size(); ++i) {
        const double to_centre = square(stack_[i].x - centre.x) + square(stack_[i].y - centre.y);
        if (to_centre >= least) continue;
        least = to_centre;
        nearest = i;
    }
    if (std::sqrt(least) > emptiest_.distance) emptiest_ = {centre, std::sqrt(least)};
    return nearest;
}

void Search::thin_out(const Cell& cell, std::size_t begin) {
    const Corners corners(cell);
    std::array<std::size_t, 4> nearest{begin, begin, begin, begin};
    std::array<Corners::Squares, 4> least{};
    for (std::size_t k = 0; k < 4; ++k) {
        for (std::size_t i = begin; i < stack_.size(); ++i)
            if (corners.to(stack_[i])[k] < corners.to(stack_[nearest[k]])[k]) nearest[k] = i;
        least[k] = corners.to(stack_[nearest[k]]);
    }
    std::size_t top = begin;
    for (std::size_t i = begin; i < stack_.size(); ++i) {
        const Corners::Squares mine = corners.to(stack_[i]);
        const auto is_no_farther = [&](const Corners::Squares& other) {
            return std::equal(other.begin(), other.end(), mine.begin(), std::less_equal<>());
        };
        const bool is_kept = std::find(nearest.begin(), nearest.end(), i) != nearest.end() ||
                             std::none_of(least.begin(), least.end(), is_no_farther);
        if (is_kept) stack_[top++] = stack_[i];
    }
    stack_.resize(top);
}

double Search::settled_from() const {
    const double emptiest = emptiest_.distance;
    const double not_worth_it = emptiest * (1 + goal_.relative);
    const bool is_beyond_limit = emptiest > goal_.limit + rounding_;
    return std::max(emptiest + goal_.finest,
                    is_beyond_limit ? not_worth_it : std::min(not_worth_it, goal_.limit));
}

}  // namespace lacuna::verify
