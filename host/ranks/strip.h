// A rank's part of the domain: a strip of its lines, with a halo of the neighbours' on either side.
#pragma once

#include <cstdint>

#include "plan/plan.h"

namespace lacuna {

// The strip's plan counts x from where its halo begins, and does not wrap along x unless the strip
// is all there is. The halo is as wide as the radius, so that whatever reaches into the strip lies
// on the strip or in the halo; at the edges of a box there is none.
struct Strip {
    Plan plan;
    std::uint32_t first_line = 0;  // of the domain's: where the plan's own lines begin
    std::uint32_t domain_width = 0;

    bool has_low_neighbour() const { return plan.halo.low != 0; }
    bool has_high_neighbour() const { return plan.halo.high != 0; }
    // Of the plan's own lines, in units of the domain.
    Sample in_domain(Sample sample) const;
};

// So many ranks can share a plan: each strip is at least two radii wide. Mode exact, no
// radius_field.
std::uint32_t most_ranks(const Plan& plan);

// Lines are shared out evenly, to within one. ranks is at most most_ranks.
Strip strip_of(const Plan& plan, std::uint32_t rank, std::uint32_t ranks);

}  // namespace lacuna
