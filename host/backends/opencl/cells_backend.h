// The opencl backend of mode cells: a bit for each lattice point.
#pragma once

#include <cstdint>
#include <memory>

#include "backends/backend.h"
#include "backends/device/layout.h"
#include "backends/opencl/program.h"
#include "plan/plan.h"

namespace lacuna::opencl {

// For a plan with a radius map. `launches`, unless null, counts the kernels launched.
std::unique_ptr<Backend> make_cells_backend(std::shared_ptr<Program> program, const Plan& plan,
                                            const device::Tuning& tuning, std::uint64_t* launches);

}  // namespace lacuna::opencl
