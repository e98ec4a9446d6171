// The backend of every device: queues the verbs, and completes each round.
#pragma once

#include <memory>

#include "backends/backend.h"
#include "backends/device/layout.h"
#include "backends/device/queue.h"
#include "plan/plan.h"

namespace lacuna::device {

// Throws Unavailable where the device is too small for the plan.
std::unique_ptr<Backend> make_backend(std::unique_ptr<Queue> queue, const Plan& plan,
                                      const Tuning& tuning);

}  // namespace lacuna::device
