// Relaxation on an OpenCL or Vulkan device.
#pragma once

#include <memory>
#include <span>

#include "backends/device/queue.h"
#include "relax/relax_backend.h"

namespace lacuna::relaxing::device {

// Used by tests.
struct Tuning {
    std::uint32_t units_of_batch = 0;  // 0: chosen for the device
};

// The lattice must outlive the backend. Throws Unavailable if the device is too small for it.
std::unique_ptr<RelaxBackend> make_backend(std::unique_ptr<lacuna::device::Queue> queue,
                                           const Lattice& lattice, std::span<const Site> sites,
                                           const Tuning& tuning = {},
                                           const Poll& poll = nobody_asks);

}  // namespace lacuna::relaxing::device
