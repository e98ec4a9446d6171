// The samplers, one sample at a time: every backend must give the same sets.
#pragma once

#include <lacuna/lacuna.h>

#include "plan/plan.h"
#include "rounds/round.h"

namespace lacuna::reference {

// Works in rounds of any size; rounds of one are the paper's algorithm. Throws Cancelled.
Outcome sample(const Plan& plan, Observer& observer);

}  // namespace lacuna::reference
