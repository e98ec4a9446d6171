// The descent of the Gaussian energy on an OpenCL or Vulkan device.
#pragma once

#include <memory>
#include <span>

#include "backends/device/queue.h"
#include "relax/gaussian_backend.h"

namespace lacuna::relaxing::device {

// Throws Unavailable if the device is too small.
std::unique_ptr<GaussianBackend> make_gaussian_backend(std::unique_ptr<lacuna::device::Queue> queue,
                                                       const GaussianField& field,
                                                       std::span<const Spot> spots);

}  // namespace lacuna::relaxing::device
