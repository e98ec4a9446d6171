// Vulkan's validation layer, for tests: what it checks, and where its messages go.
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
    // Called with "ID: TEXT", from any thread. Versions of the layer word their texts in different
    // ways, and agree in their ids.
    std::function<void(const std::string& message)> report;
};

}  // namespace lacuna::vulkan
