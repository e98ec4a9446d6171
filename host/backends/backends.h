// The backends that this build has, in order of preference, and how one is chosen.
#pragma once

#include <lacuna/lacuna.h>

#include "generate.h"
#include "plan/plan.h"

namespace lacuna {

struct Run {
    Outcome outcome;
    std::string backend;
    std::string device;
};

// Runs the plan on the backend that the request asks for, or throws Unavailable.
Run run_on_backend(const Request& request, const Plan& plan, Observer& observer);

}  // namespace lacuna
