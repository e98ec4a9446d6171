// The cpu backend: threads that serve columns of bins.
#pragma once

#include <memory>

#include "backends/backend.h"
#include "plan/plan.h"

namespace lacuna::cpu {

std::unique_ptr<Backend> make_backend(const Plan& plan, const Placement& placement);

}  // namespace lacuna::cpu
