// The kernels, compiled: once a device and process, for all backends.
#pragma once

#include <memory>
#include <string>

#include "backends/opencl/cl.h"
#include "backends/opencl/devices.h"
#include "backends/opencl/errors.h"

namespace lacuna::opencl {

struct Program {
    DeviceEntry entry;
    Log log;  // before the context, whose driver writes to it
    cl::Device device;
    cl::Context context;
    cl::Program program;
};

// Compiles the source for the device, or finds it compiled. Throws DeviceError with the build log.
std::shared_ptr<Program> compiled(const Found& found, const std::string& source);

}  // namespace lacuna::opencl
