// Mode exact, one sample at a time.
#pragma once

#include <lacuna/lacuna.h>

#include "generate.h"
#include "plan/plan.h"

namespace lacuna::reference {

// DESIGN section 4, "exact". Throws Cancelled.
Outcome sample_exact(const Plan& plan, Observer& observer);

}  // namespace lacuna::reference
