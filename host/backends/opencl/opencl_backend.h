// The opencl backend: the verbs as kernels of OpenCL C 1.2 (kernels/*.cl).
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "backends/backend.h"
#include "backends/device/choice.h"
#include "backends/device/layout.h"
#include "backends/device/queue.h"

namespace lacuna::opencl {

// Throws Unavailable, with the reason.
std::unique_ptr<Backend> make_backend(const Plan& plan, const Placement& placement);

std::vector<DeviceEntry> list_devices();

// For tests, which must be able to show that these kernels do the work.
struct Trial {
    std::vector<std::string> sources{};  // searched for a kernel before the embedded ones
};
std::unique_ptr<Backend> make_backend(const Plan& plan, const Placement& placement,
                                      const device::Tuning& tuning, const Trial& trial = {});
std::unique_ptr<space::SpaceBackend> make_space_backend(const Plan& plan,
                                                        const Placement& placement,
                                                        const Trial& trial = {});
std::unique_ptr<device::Queue> open_queue(const Placement& placement, const Trial& trial = {});

}  // namespace lacuna::opencl
