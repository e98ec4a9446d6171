// The queue of an OpenCL device.
#pragma once

#include <memory>

#include "backends/device/queue.h"
#include "backends/opencl/program.h"

namespace lacuna::opencl {

// For the kernels of the program.
std::unique_ptr<device::Queue> make_queue(std::shared_ptr<Program> program);

}  // namespace lacuna::opencl
