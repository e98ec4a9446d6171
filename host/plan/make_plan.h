// Turns a checked request into a plan. Each mode has a file of its own.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <span>

#include "base/polling.h"
#include "plan/checked_request.h"
#include "plan/plan.h"

namespace lacuna {

// The plan of modes exact, lines and cells. The request must have a radius or, with a field, a
// scale. Throws BadRequest, also for a size that is too small or too large, or kept points that are
// too close together at it, and MemoryRefused.
Plan make_plan(const CheckedRequest& request);

// Sums over the pixels of one field, computed once for all its plans. An importance is taken as a
// fraction of the greatest one.
struct FieldSums {
    double greatest;
    double shares;           // sum of the fractions
    double shares_and_half;  // sum of the fractions to the power of 1.5
};
FieldSums sums_of(const Field& field, const Poll& poll = nobody_asks);
// make_plan for mode cells (plan_cells.cpp).
Plan make_cells_plan(const CheckedRequest& request, const FieldSums& sums,
                     const Poll& poll = nobody_asks);

// make_plan for mode exact with a radius field (plan_radius_field.cpp). Unlike make_plan it does
// not check the distances of kept points: check_kept_distances() must have. The plan keeps
// `samples`, too, which lie where samples may lie and keep their distances.
Plan make_radius_field_plan(const CheckedRequest& request, const Poll& poll = nobody_asks,
                            std::span<const Sample> samples = {});

// The grid of a domain that is `width` x `height` units large, for a radius.
GridShape grid_of(std::uint32_t width, std::uint32_t height, std::uint32_t radius);

// Fills in what every mode's plan takes from the request in the same way, once the plan has its
// width, height and radius. `expected` is the number of samples of a maximal set.
void finish_plan(Plan& plan, const Request& request, std::uint64_t limit, double expected);

}  // namespace lacuna
