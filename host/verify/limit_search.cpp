// Cuts cells until each is settled.
#include "verify/limit_search.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "verify/corners.h"
#include "verify/emptiest.h"

namespace lacuna::verify {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// More disks than this, hardly fewer than those of the cell that was cut, are a crowd.
constexpr std::size_t kCrowdOfLimits = 64;

// The part that is farther from the disk that covers the centre best comes first: else a slope
// would be climbed in the smallest steps, each of them a new record.
std::pair<Cell, Cell> parts_of(const Cell& cell, const Cut& cut, const Frame& frame, Point best) {
    const bool is_high_farther = cut.is_of_x ? best.x < frame.centre.x : best.y < frame.centre.y;
    if (is_high_farther) return {cut.high(cell), cut.low(cell)};
    return {cut.low(cell), cut.high(cell)};
}

}  // namespace

BareSpot LimitSearch::run(const Cell& cell, const Under& under, std::vector<Disk> disks) {
    stack_ = std::move(disks);
    visit(cell, under, 0);
    return barest_;
}

void LimitSearch::visit(const Cell& cell, const Under& outer, std::size_t begin) {
    constexpr std::uint32_t kSeldom = 1U << 10U;
    if (++visits_ % kSeldom == 0) limits_.patience.look();
    const Under under = limits_.ground.under(cell, outer);
    const Frame frame(cell);
    const double settled = settled_from();
    const bool is_a_spot = std::max(frame.half_width, frame.half_height) < limits_.finest / 4;
    if (under.is_closed() || is_a_spot || settled == kInfinity) return;

    const Bounds bounds(frame, under);
    const std::size_t end = stack_.size();
    double most_over = kInfinity;
    for (std::size_t i = begin; i < end; ++i) {
        if (bounds.is_at_most(stack_[i], settled - limits_.rounding)) return;
        most_over = std::min(most_over, bounds.most_over(stack_[i]));
    }
    Point best = frame.centre;
    const std::size_t best_index = look_from(frame.centre, under, begin);
    if (begin < end) {
        best = stack_[best_index].at;
        // First, as it is likely to cover a part.
        std::swap(stack_[begin], stack_[best_index]);
    }
    for (std::size_t i = begin; i < end; ++i) {
        const Disk disk = stack_[i];
        if (bounds.may_matter(disk, most_over + limits_.rounding)) stack_.push_back(disk);
    }
    if (stack_.size() - end > kCrowdOfLimits && 8 * (stack_.size() - end) > 7 * (end - begin))
        thin_out(cell, bounds, end);
    const std::size_t top = stack_.size();
    const auto [first, second] = parts_of(cell, limits_.ground.cut(cell, under), frame, best);
    visit(first, under, end);
    stack_.resize(top);
    visit(second, under, end);
    stack_.resize(end);
}

std::size_t LimitSearch::look_from(Point centre, const Under& under, std::size_t begin) {
    const std::optional<double> radius = limits_.ground.radius_at(centre);
    const double reach = radius.value_or(under.radii.most);
    std::size_t best = begin;
    double least = kInfinity;
    for (std::size_t i = begin; i < stack_.size(); ++i) {
        const Disk& disk = stack_[i];
        const double distance =
            std::sqrt(square(disk.at.x - centre.x) + square(disk.at.y - centre.y));
        const double over = distance - std::min(disk.radius, reach);
        if (over >= least) continue;
        least = over;
        best = i;
    }
    if (radius && least > barest_.over) {
        barest_.at = centre;
        barest_.over = least;
    }
    return best;
}

void LimitSearch::thin_out(const Cell& cell, const Bounds& bounds, std::size_t begin) {
    const Corners corners(cell);
    // Of each corner the nearest, and the one that covers it best.
    std::array<std::size_t, 8> chosen{};
    for (std::size_t k = 0; k < 4; ++k) {
        double nearest = kInfinity;
        double least_over = kInfinity;
        for (std::size_t i = begin; i < stack_.size(); ++i) {
            const double distance = std::sqrt(corners.to(stack_[i].at)[k]);
            if (distance < std::exchange(nearest, std::min(nearest, distance))) chosen[k] = i;
            const double over = distance - bounds.effective(stack_[i]);
            if (over < std::exchange(least_over, std::min(least_over, over))) chosen[k + 4] = i;
        }
    }
    std::array<Disk, 8> standing{};
    for (std::size_t k = 0; k < 8; ++k) standing[k] = stack_[chosen[k]];
    std::size_t top = begin;
    for (std::size_t i = begin; i < stack_.size(); ++i) {
        const Disk disk = stack_[i];
        const Corners::Squares mine = corners.to(disk.at);
        const auto stands_for_it = [&](const Disk& other) {
            const Corners::Squares others = corners.to(other.at);
            return bounds.effective(other) >= bounds.effective(disk) &&
                   std::equal(others.begin(), others.end(), mine.begin(), std::less_equal<>());
        };
        const bool is_standing = std::find(chosen.begin(), chosen.end(), i) != chosen.end();
        if (is_standing || std::none_of(standing.begin(), standing.end(), stands_for_it))
            stack_[top++] = disk;
    }
    stack_.resize(top);
}

double LimitSearch::settled_from() const {
    const double over = barest_.over;
    if (over > limits_.tolerance + limits_.rounding)
        return over + std::max(limits_.finest, over * kSpotPrecision);
    return std::max(limits_.tolerance, over + limits_.finest);
}

}  // namespace lacuna::verify
