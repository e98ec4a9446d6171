// The samplers, one sample at a time: the yardstick of every backend.
#pragma once

#include <lacuna/lacuna.h>

#include "plan/plan.h"
#include "sampling/generate.h"

namespace lacuna::reference {

// In rounds of any size; rounds of one are the paper's algorithm. Throws Cancelled.
Outcome sample(const Plan& plan, Observer& observer);

}  // namespace lacuna::reference
