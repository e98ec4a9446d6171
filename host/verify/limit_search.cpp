// Cuts cells until each is settled.
#include "verify/limit_search.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "verify/bounds.h"
#include "verify/emptiest.h"

namespace lacuna::verify {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
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
    thin_out(cell, bounds, end - begin, stack_, end);
    const std::size_t top = stack_.size();
    const auto [first, second] = parts_of(cell, limits_.ground.cut(cell, under), frame, best);
    visit(first, under, end);
    stack_.resize(top);
    visit(second, under, end);
    stack_.resize(end);
}

std::size_t LimitSearch::look_from(Point centre, const Under& under, std::size_t begin) {
    // Where all places are alike there is no need to look at polygons for each.
    std::optional<double> radius =
        under.is_plain() ? under.radii.least : limits_.ground.radius_at(centre);
    // At the border of two pixels rounding may take the other one's: the disks at hand are those
    // that matter to the cell's own radii.
    if (radius) radius = std::clamp(*radius, under.radii.least, under.radii.most);
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
        barest_.radius = *radius;
        barest_.over = least;
    }
    return best;
}

double LimitSearch::settled_from() const {
    const double over = barest_.over;
    if (over > limits_.tolerance + limits_.rounding)
        return over + std::max(limits_.finest, over * kSpotPrecision);
    return std::max(limits_.tolerance, over + limits_.finest);
}

}  // namespace lacuna::verify
