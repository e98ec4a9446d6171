// The backends that this build has, in order of preference, and how one is chosen.
#pragma once

#include <lacuna/lacuna.h>

#include <memory>
#include <string>

#include "backends/backend.h"
#include "plan/plan.h"

namespace lacuna {

// The backend that was asked for or, where that is "auto", the environment's LACUNA_BACKEND.
std::string wanted_backend(const std::string& asked);

// The name of the backend that a request asks for, also as "auto". Throws BadRequest if there is
// none of that name, or if it has no devices and one is named.
std::string backend_named(const RunOn& run_on);

// The error for a backend that does not exist. All builds know the same names.
BadRequest no_such_backend(const std::string& wanted);

// The backend of this place. The plan may be of one strip (ranks/strip.h). The
// reference has a loop instead of verbs: its backend is null. Throws Unavailable, DeviceError.
struct ReadyBackend {
    std::unique_ptr<Backend> backend;
    std::string name;
};
ReadyBackend make_backend(const RunOn& run_on, const Plan& plan, Observer& observer);

}  // namespace lacuna
