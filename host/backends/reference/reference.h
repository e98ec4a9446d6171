// The uniform samplers, one sample at a time: the yardstick of every backend.
#pragma once

#include <lacuna/lacuna.h>

#include "generate.h"
#include "plan/plan.h"

namespace lacuna::reference {

// Mode lines: Kalantari & Sen 2011, section 4.1, in rounds of any size; rounds of one are the
// paper's algorithm. Mode exact: DESIGN section 4. Throws Cancelled.
Outcome sample(const Plan& plan, Observer& observer);

}  // namespace lacuna::reference
