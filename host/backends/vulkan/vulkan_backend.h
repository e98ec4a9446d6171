// The vulkan backend: the verbs as compute shaders (kernels/*.cl). It needs only Vulkan 1.2 and
// 64-bit integers in shaders.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "backends/backend.h"
#include "backends/device/choice.h"
#include "backends/device/layout.h"
#include "backends/device/queue.h"
#include "backends/vulkan/validation.h"

namespace lacuna::vulkan {

// Throws Unavailable, with the reason.
std::unique_ptr<Backend> make_backend(const Plan& plan, const Placement& placement);

std::vector<DeviceEntry> list_devices();

// Asked for the SPIR-V words of a kernel at its first launch; the embedded shader's if none are
// given.
using ShaderOf = std::function<std::vector<std::uint32_t>(std::string_view kernel)>;

// For tests, which must show that these shaders do the work, and that they obey Vulkan's rules.
struct Trial {
    ShaderOf shader_of{};
    const Validation* validation = nullptr;  // must outlive the backend
};
std::unique_ptr<Backend> make_backend(const Plan& plan, const Placement& placement,
                                      const device::Tuning& tuning, const Trial& trial = {});
std::unique_ptr<space::SpaceBackend> make_space_backend(const Plan& plan,
                                                        const Placement& placement,
                                                        const Trial& trial = {});
std::unique_ptr<device::Queue> open_queue(const Placement& placement, const Trial& trial = {});

}  // namespace lacuna::vulkan
