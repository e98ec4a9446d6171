// The opencl backend: chooses a device and prepares it.
#include "backends/opencl/opencl_backend.h"

#include "backends/device/device_backend.h"
#include "backends/opencl/device.h"

namespace lacuna::opencl {

std::unique_ptr<Backend> make_backend(const Plan& plan, const Placement& placement) {
    return make_backend(plan, placement, device::Tuning{});
}

std::unique_ptr<Backend> make_backend(const Plan& plan, const Placement& placement,
                                      const device::Tuning& tuning, const Trial& trial) {
    return device::make_backend(open_queue(placement, trial), plan, placement.threads, tuning);
}

std::unique_ptr<space::SpaceBackend> make_space_backend(const Plan& plan,
                                                        const Placement& placement,
                                                        const Trial& trial) {
    return device::make_space_backend(open_queue(placement, trial), plan, placement.threads);
}

std::unique_ptr<device::Queue> open_queue(const Placement& placement, const Trial& trial) {
    return make_queue(kept_device(placement.device), trial.sources);
}

}  // namespace lacuna::opencl
