// The vulkan backend of mode cells: a bit for each lattice point.
#pragma once

#include <memory>

#include "backends/backend.h"
#include "backends/vulkan/engine.h"
#include "backends/vulkan/make_backend.h"
#include "plan/plan.h"

namespace lacuna::vulkan {

// For a plan with a radius map.
std::unique_ptr<Backend> make_cells_backend(std::unique_ptr<Engine> engine, const Plan& plan,
                                            const Trial& trial);

}  // namespace lacuna::vulkan
