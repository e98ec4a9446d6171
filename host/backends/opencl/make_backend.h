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

// For tests, which must be able to tell that these kernels do the work.
struct Trial {
    std::string source;                 // in place of the mode's own, unless empty
    std::uint64_t* launches = nullptr;  // counts the kernels launched
};
std::unique_ptr<Backend> make_backend(const Plan& plan, const Placement& placement,
                                      const device::Tuning& tuning, const Trial& trial = {});
// For the kernels of `source`, unless the trial has its own.
std::unique_ptr<device::Queue> open_queue(const Placement& placement, std::string source,
                                          const Trial& trial = {});

// The OpenCL C source of the kernels, includes expanded: of modes lines and exact, of mode cells,
// of relax.
std::string kernel_source();
std::string cells_kernel_source();
std::string relax_kernel_source();

}  // namespace lacuna::opencl
