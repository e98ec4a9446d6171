// Dart throwing (section 1 of the paper; Dippe & Wold 1985, Cook 1986): has the distribution that
// Lacuna must have. It stops after a number of misses in a row, so its sets are not maximal.
#pragma once

#include <cstdint>
#include <vector>

#include "plan/plan.h"

namespace lacuna::baseline {

struct Darts {
    std::vector<Sample> samples;  // in the order in which they were kept
    std::uint64_t thrown = 0;
};

// Throws uniform darts at the plan's domain, and keeps those at least plan.radius away from all
// darts kept before, until `misses_in_a_row` misses or plan.limit kept darts. Ignores the plan's
// lines.
Darts throw_darts(const Plan& plan, std::uint64_t misses_in_a_row);

}  // namespace lacuna::baseline
