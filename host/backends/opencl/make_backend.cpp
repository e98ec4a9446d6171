// The opencl backend: chooses a device, and compiles the kernels for it.
#include "backends/opencl/make_backend.h"

#include <utility>

#include "backends/device/device_backend.h"
#include "backends/opencl/devices.h"
#include "backends/opencl/program.h"
#include "backends/opencl/queue.h"

namespace lacuna::opencl {

std::unique_ptr<Backend> make_backend(const Plan& plan, const Placement& placement) {
    return make_backend(plan, placement, device::Tuning{});
}

std::unique_ptr<Backend> make_backend(const Plan& plan, const Placement& placement,
                                      const device::Tuning& tuning, const Trial& trial) {
    std::string source = plan.mode == Mode::cells ? cells_kernel_source() : kernel_source();
    return device::make_backend(open_queue(placement, std::move(source), trial), plan, tuning);
}

std::unique_ptr<device::Queue> open_queue(const Placement& placement, std::string source,
                                          const Trial& trial) {
    if (!trial.source.empty()) source = trial.source;
    auto queue = make_queue(compiled(choose_device(placement.device), source));
    queue->count_launches(trial.launches);
    return queue;
}

}  // namespace lacuna::opencl
