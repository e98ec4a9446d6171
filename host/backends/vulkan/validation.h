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
    // Called with "ID: TEXT", from any thread. The ids are the same in all versions of the layer,
    // the texts are not.
    std::function<void(const std::string& message)> report;
};

}  // namespace lacuna::vulkan
