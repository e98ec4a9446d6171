// The vulkan backend: chooses a device and prepares it.
#include "backends/vulkan/vulkan_backend.h"

#include "backends/device/device_backend.h"
#include "backends/vulkan/device.h"

namespace lacuna::vulkan {
namespace {

// A device for one test, with the test's validation layer.
std::shared_ptr<Device> validated_device(const Placement& placement, const Validation* validation) {
    auto instance = std::make_shared<const Instance>(validation);
    const std::size_t number = choose_device(*instance, placement.device);
    return std::make_shared<Device>(std::move(instance), number, validation);
}

}  // namespace

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
    return make_queue(trial.validation == nullptr ? kept_device(placement.device)
                                                  : validated_device(placement, trial.validation),
                      trial.shader_of);
}

}  // namespace lacuna::vulkan
