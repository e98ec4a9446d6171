// Cuts cells until each is decided.
#include "verify/gap_search.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "verify/bounds.h"
#include "verify/ellipse_bounds.h"

namespace lacuna::verify {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

// Where a spot's distance from the sample that covers it best grows fastest.
Point uphill(const Disk& best, Point spot, const EllipseShape*) {
    return {spot.x - best.at.x, spot.y - best.at.y};
}
Point uphill(const Ellipse& best, Point spot, const EllipseShape* of_spot) {
    const Point way{spot.x - best.at.x, spot.y - best.at.y};
    const bool is_of_spot = of_spot != nullptr && of_spot->over(way) > best.shape->over(way);
    return (is_of_spot ? of_spot : best.shape)->slope(way);
}

// The two parts of a cell, in the order to visit them. The part that lies in the direction uphill
// comes first. Otherwise the search would climb towards a gap in the smallest steps, with a new
// record at each step.
std::pair<Cell, Cell> parts_of(const Cell& cell, const Cut& cut, Point direction) {
    const bool is_high_farther = cut.is_of_x ? direction.x > 0 : direction.y > 0;
    if (is_high_farther) return {cut.high(cell), cut.low(cell)};
    return {cut.low(cell), cut.high(cell)};
}

}  // namespace

bool drops_few(std::size_t samples, std::size_t kept) {
    constexpr std::size_t kMany = 65536;
    return samples > kMany && kept > samples / 4 * 3;
}

template <typename Sample>
Gap GapSearch<Sample>::run(const Cell& cell, const Under& under, std::vector<Sample> samples) {
    stack_ = std::move(samples);
    visit(cell, under, 0);
    return gap_;
}

template <typename Sample>
void GapSearch<Sample>::visit(const Cell& cell, const Under& outer, std::size_t begin) {
    constexpr std::uint32_t kVisitsPerLook = 1U << 10U;
    if (++visits_ % kVisitsPerLook == 0) question_.patience.look();
    const Under under = question_.radius_field.under(cell, outer);
    const Frame frame(cell);
    const double decided = decided_from();
    const bool is_a_spot = std::max(frame.half_width, frame.half_height) < question_.finest / 4;
    if (under.is_closed() || is_a_spot || decided == kEndless) return;

    const Bounds<Sample> bounds(frame, under);
    const std::size_t end = stack_.size();
    double most_over = kEndless;
    for (std::size_t i = begin; i < end; ++i) {
        if (bounds.is_at_most(stack_[i], decided - question_.rounding)) return;
        bounds.lower_to_most_over(stack_[i], most_over);
    }
    Point direction{0, 0};
    const std::size_t best_index = look_from(cell, frame.centre, under, begin);
    if (begin < end) {
        direction = uphill(stack_[best_index], frame.centre, under.shape);
        // The best sample goes first, because it is likely to cover one of the parts.
        std::swap(stack_[begin], stack_[best_index]);
    }
    push_those_that_matter(cell, bounds, most_over, begin, end);
    const bool are_few_dropped = drops_few(end - begin, stack_.size() - end);
    if (are_few_dropped) stack_.resize(end);
    const std::size_t begin_of_parts = are_few_dropped ? begin : end;
    const std::size_t top = stack_.size();
    const auto [first, second] = parts_of(cell, question_.radius_field.cut(cell, under), direction);
    visit(first, under, begin_of_parts);
    stack_.resize(top);
    visit(second, under, begin_of_parts);
    stack_.resize(end);
}

template <typename Sample>
void GapSearch<Sample>::push_those_that_matter(const Cell& cell, const Bounds<Sample>& bounds,
                                               double most_over, std::size_t begin,
                                               std::size_t end) {
    const double reach = most_over + question_.rounding;
    stack_.resize(end + (end - begin));
    std::size_t top = end;
    for (std::size_t i = begin; i < end; ++i) {
        stack_[top] = stack_[i];
        top += bounds.may_matter(stack_[i], reach) ? 1U : 0U;
    }
    stack_.resize(top);
    thin_out(cell, bounds, end - begin, stack_, end);
}

template <>
std::size_t GapSearch<Disk>::look_from(const Cell&, Point centre, const Under& under,
                                       std::size_t begin) {
    // In a plain cell all spots have one radius, and mask and polygons need not be looked at.
    std::optional<double> radius =
        under.is_plain() ? under.radii.least : question_.radius_field.radius_at(centre);
    // On the border of two pixels, rounding may give the radius of the other pixel. But the stack
    // has only the samples that matter to the radii of this cell.
    if (radius) radius = std::clamp(*radius, under.radii.least, under.radii.most);
    const double reach = radius.value_or(under.radii.most);
    // With limits of 0 only distances are compared. Their squares are not rounded by a square root.
    const bool by_squares = reach == 0;
    std::size_t best = begin;
    double least = kEndless;
    for (std::size_t i = begin; i < stack_.size(); ++i) {
        const Disk& disk = stack_[i];
        const double squared = square(disk.at.x - centre.x) + square(disk.at.y - centre.y);
        const double over = by_squares ? squared : std::sqrt(squared) - disk.limit_with(reach);
        if (over >= least) continue;
        least = over;
        best = i;
    }
    if (by_squares) least = std::sqrt(least);
    if (radius && least > gap_.over) {
        gap_.at = centre;
        gap_.radius = *radius;
        gap_.over = least;
    }
    return best;
}

template <>
std::size_t GapSearch<Ellipse>::look_from(const Cell& cell, Point centre, const Under& under,
                                          std::size_t begin) {
    const bool is_known = under.is_plain() && under.shape != nullptr;
    const EllipseShape* const shape =
        is_known ? under.shape : question_.radius_field.shape_at(centre, cell);
    std::size_t best = begin;
    double least = kEndless;
    for (std::size_t i = begin; i < stack_.size(); ++i) {
        const Ellipse& ellipse = stack_[i];
        const double over = ellipse.over(centre, shape != nullptr ? *shape : *ellipse.shape);
        if (over >= least) continue;
        least = over;
        best = i;
    }
    if (shape != nullptr && least > gap_.over) {
        gap_.at = centre;
        gap_.shape = shape;
        gap_.over = least;
    }
    return best;
}

template <typename Sample>
double GapSearch<Sample>::decided_from() const {
    const double over = gap_.over;
    const double larger = over * (1 + question_.precision);
    const double tolerance = question_.tolerance;
    const bool is_uncovered = over > tolerance + question_.rounding;
    const double decided = is_uncovered              ? larger
                           : question_.names_any_gap ? std::min(larger, tolerance)
                                                     : tolerance;
    return std::max(over + question_.finest, decided);
}

template class GapSearch<Disk>;
template class GapSearch<Ellipse>;

}  // namespace lacuna::verify
