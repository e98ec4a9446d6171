// Vulkan's validation layer, for tests: what it is to check, and who hears of it.
#pragma once

#include <functional>
#include <string>

namespace lacuna::vulkan {

enum class Checks {
    core_and_synchronization,
    gpu_assisted,  // instruments the shaders; not together with the others
};

struct Validation {
    Checks checks;
    std::function<void(const std::string& message)> report;  // may come from any thread
};

}  // namespace lacuna::vulkan
