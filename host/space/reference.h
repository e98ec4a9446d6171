// Samples in space one at a time: every backend must give the same sets.
#pragma once

#include <lacuna/run.h>

#include "plan/plan.h"
#include "rounds/round.h"
#include "space/portion.h"

namespace lacuna::space {

// Throws Cancelled.
OutcomeOf<SpaceSample> reference_samples(const Plan& plan, Observer& observer);

}  // namespace lacuna::space
