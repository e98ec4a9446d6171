// A request that was checked: plans are made of nothing else, so no request is checked twice or
// never.
#pragma once

#include <lacuna/lacuna.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "plan/kept.h"

namespace lacuna {

// Checks everything that does not depend on the radius. Throws BadRequest.
void check_request(const Request& request);

// A request that check_request() has accepted, as plans are made of it: places are masks and
// borders; classes give it the radius or scale of their least distance if it has none and no
// count; one class is the same as none.
class CheckedRequest {
public:
    // Throws BadRequest. Implicit, so that a plan can be made of a request.
    CheckedRequest(const Request& request);  // NOLINT(google-explicit-constructor)

    // The request after change(Request&), which sets what the caller has found: a size in place of
    // a count, a limit, or how a pilot run is made.
    template <class Change>
    CheckedRequest with(const Change& change) const {
        CheckedRequest changed = *this;
        change(changed.resolved_.request);
        changed.sort_kept();
        return changed;
    }

    // How many kept points lie in the domain, and so are points of the set. They are the first of
    // Request::keep; those that follow lie outside, and none of them is farther from the domain
    // than the greatest distance that two points keep.
    std::size_t members() const { return kept_ ? kept_->members : (*this)->keep.size(); }

    // The place that each kept point had in the request as it was given; empty: the same.
    std::span<const std::uint32_t> places_of_kept() const {
        return kept_ ? std::span<const std::uint32_t>(kept_->places)
                     : std::span<const std::uint32_t>();
    }

    // How far outlines are off: Resolved::edge.
    double edge() const { return resolved_.edge; }

    const Request& operator*() const { return resolved_.request; }
    const Request* operator->() const { return &resolved_.request; }
    // NOLINTNEXTLINE(google-explicit-constructor)
    operator const Request&() const { return resolved_.request; }

private:
    void sort_kept();

    Resolved resolved_;
    std::shared_ptr<const SortedKept> kept_;  // null: all lie in the domain
};

// Checks the names, weights, distances and counts of classes (check_classes.cpp). Throws
// BadRequest.
void check_classes(const Request& request);
// Checks where samples may lie (check_where.cpp): the mask, the border and the kept points, but not
// the points' distances, which depend on the radius. Throws BadRequest.
void check_where(const Request& request);
// Whether samples may lie anywhere, by a mask or by all masks of a request that were checked. If
// not, a set is empty, and a count is refused.
bool allows_some(const Mask& mask);
bool has_places(const Request& request);

// Whether the plan of the request has a radius field: mode exact with a field, a mask, a border,
// kept points, classes or a progressive order.
bool needs_radius_field(const Request& request);
// The default m of mode cells: the least with reasonable quality in figure 4.
inline constexpr std::uint32_t kCellsPerRadius = 10;
// The request's m, or the default of its mode.
std::uint32_t lines_per_radius(const Request& request);

}  // namespace lacuna
