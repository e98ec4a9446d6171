// A rank's part of the domain: a strip of lines, with a halo of the neighbours' lines.
#pragma once

#include <cstdint>

#include "plan/plan.h"

namespace lacuna {

// In the strip's plan x begins at the halo, and x does not wrap unless the strip is the whole
// domain. The halo is as wide as the radius, so that every sample that reaches into the strip lies
// in the strip or in the halo. At the edges of a box there is no halo.
struct Strip {
    Plan plan;
    std::uint32_t first_line = 0;  // the domain's line with which the plan's own lines begin
    std::uint32_t domain_width = 0;

    bool has_low_neighbour() const { return plan.halo().low != 0; }
    bool has_high_neighbour() const { return plan.halo().high != 0; }
    // Converts a sample on the plan's own lines to the domain's coordinates.
    Sample in_domain(Sample sample) const;
};

// Most ranks for a plan: each strip is at least two radii wide. Mode exact without a radius field.
std::uint32_t most_ranks(const Plan& plan);

// Each rank gets equally many lines, to within one. `ranks` is at most most_ranks.
Strip strip_of(const Plan& plan, std::uint32_t rank, std::uint32_t ranks);

}  // namespace lacuna
