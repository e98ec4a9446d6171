// Dart throwing (section 1 of the paper; Dippe & Wold 1985, Cook 1986): the distribution that
// Lacuna must have, made the simple way. Not maximal: it stops after so many misses in a row.
#pragma once

#include <cstdint>
#include <vector>

#include "plan/plan.h"

namespace lacuna::baseline {

struct Darts {
    std::vector<Sample> samples;  // in the order in which they stuck
    std::uint64_t thrown = 0;
};

// Throws uniform darts at the plan's domain and keeps those at least plan.radius from all kept
// before, until `misses_in_a_row` have missed or plan.limit have stuck. Lines play no part.
Darts throw_darts(const Plan& plan, std::uint64_t misses_in_a_row);

}  // namespace lacuna::baseline
