// Mode cells, one sample at a time.
#pragma once

#include <lacuna/lacuna.h>

#include "generate.h"
#include "plan/plan.h"

namespace lacuna::reference {

// Kalantari & Sen 2011, section 4.2. Throws Cancelled.
Outcome sample_cells(const Plan& plan, Observer& observer);

}  // namespace lacuna::reference
