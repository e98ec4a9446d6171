// The cpu backend of mode cells: a bit for each lattice point.
#pragma once

#include <cstdint>
#include <memory>

#include "backends/backend.h"
#include "plan/plan.h"

namespace lacuna::cpu {

// For a plan with a radius map.
std::unique_ptr<Backend> make_cells_backend(const Plan& plan, std::uint32_t threads);

}  // namespace lacuna::cpu
