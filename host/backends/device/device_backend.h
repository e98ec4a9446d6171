// The backend of every device: queues the verbs, and completes each round.
#pragma once

#include <cstdint>
#include <memory>

#include "backends/backend.h"
#include "backends/device/layout.h"
#include "backends/device/queue.h"
#include "plan/plan.h"

namespace lacuna::device {

// The host's part has `threads` threads, 0: one for each core. Throws Unavailable where the device
// is too small for the plan.
std::unique_ptr<Backend> make_backend(std::unique_ptr<Queue> queue, const Plan& plan,
                                      std::uint32_t threads, const Tuning& tuning);

// The same for surfaces and volumes.
std::unique_ptr<space::SpaceBackend> make_space_backend(std::unique_ptr<Queue> queue,
                                                        const Plan& plan, std::uint32_t threads);

}  // namespace lacuna::device
