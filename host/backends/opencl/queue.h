// The queue of an OpenCL device.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "backends/device/queue.h"
#include "backends/opencl/device.h"

namespace lacuna::opencl {

// A kernel is compiled when it is first launched: from the first of `sources` that has it, else
// from kernel_sources().
std::unique_ptr<device::Queue> make_queue(std::shared_ptr<Device> device,
                                          const std::vector<std::string>& sources);

}  // namespace lacuna::opencl
