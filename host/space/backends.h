// The backends of sets in space, and the choice among them.
#pragma once

#include <lacuna/run.h>

#include <memory>
#include <string>

#include "backends/backend.h"
#include "plan/plan.h"

namespace lacuna::space {

// The backend of this name, which backend_named() of backends/backends.h has checked; null for the
// reference, which has a loop of its own. Throws Unavailable, DeviceError.
std::unique_ptr<SpaceBackend> make_backend(const std::string& name, const Plan& plan,
                                           const RunOn& run_on, Observer& observer);

}  // namespace lacuna::space
