// The OpenCL devices of this machine.
#pragma once

#include <string>
#include <vector>

#include "backends/device/choice.h"
#include "backends/opencl/cl.h"

namespace lacuna::opencl {

// The device is null for the entry of a platform that has none.
struct Found {
    DeviceEntry entry;
    cl::Device device;
};

std::vector<Found> find_devices();

// The device that a request names, see device::choose. Throws Unavailable.
Found choose_device(const std::string& wanted);

}  // namespace lacuna::opencl
