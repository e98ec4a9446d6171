// The cpu backend in space, on threads.
#pragma once

#include <cstdint>
#include <memory>

#include "backends/backend.h"
#include "plan/plan.h"

namespace lacuna::space {

// `threads`: 0 for one for each core. Refers to the plan.
std::unique_ptr<SpaceBackend> make_cpu_backend(const Plan& plan, std::uint32_t threads);

}  // namespace lacuna::space
