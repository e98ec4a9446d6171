// The Vulkan loader, its devices, and the validation layer. Includes all of Vulkan's C++ headers,
// which take seconds to compile: for this folder's .cpp files only.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>
#include <vulkan/vulkan_raii.hpp>

#include "backends/device/choice.h"
#include "backends/vulkan/validation.h"

namespace lacuna::vulkan {

class Instance {
public:
    // Throws Unavailable when there is no loader, no driver, or no validation layer.
    explicit Instance(const Validation* validation);
    Instance(const Instance&) = delete;
    Instance& operator=(const Instance&) = delete;

    const std::vector<vk::raii::PhysicalDevice>& devices() const { return devices_; }

private:
    vk::raii::Context context_;
    std::optional<vk::raii::Instance> instance_;
    std::optional<vk::raii::DebugUtilsMessengerEXT> messenger_;
    std::vector<vk::raii::PhysicalDevice> devices_;
};

// The instance of the process, made at its first use.
std::shared_ptr<const Instance> kept_instance();

DeviceEntry describe(const vk::raii::PhysicalDevice& device);

// The first queue family that can compute, if there is one.
std::optional<std::uint32_t> compute_family(const vk::raii::PhysicalDevice& device);

// The number of the wanted device. Throws Unavailable.
std::size_t choose_device(const Instance& instance, std::string_view wanted);

// Makes a device with one queue of the family.
vk::raii::Device make_device(const vk::raii::PhysicalDevice& physical, std::uint32_t family,
                             const Validation* validation);

}  // namespace lacuna::vulkan
