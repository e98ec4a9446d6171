// The vulkan backend: the verbs as compute shaders (shaders/*.comp). Needs Vulkan 1.2 and
// 64-bit integers in shaders, nothing else.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "backends/backend.h"
#include "backends/device/choice.h"
#include "backends/device/layout.h"
#include "backends/vulkan/programs.h"
#include "backends/vulkan/validation.h"

namespace lacuna::vulkan {

// Throws Unavailable, with the reason.
std::unique_ptr<Backend> make_backend(const Plan& plan, const Placement& placement);

std::vector<DeviceEntry> list_devices();

// For tests, which must be able to tell that these shaders do the work, and do it by the rules.
struct Trial {
    std::optional<Programs> programs;        // in place of embedded_programs()
    const Validation* validation = nullptr;  // must outlive the backend
    std::uint64_t* dispatches = nullptr;     // counts them
};
std::unique_ptr<Backend> make_backend(const Plan& plan, const Placement& placement,
                                      const device::Tuning& tuning, const Trial& trial = {});

}  // namespace lacuna::vulkan
