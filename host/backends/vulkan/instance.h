// The Vulkan loader, its devices, and the validation layer. Includes all of Vulkan's C++ headers,
// which cost seconds: only for this folder's .cpp files.
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
    // Throws Unavailable when there is no loader, no driver, or no validation layer to be had.
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

// The one that all of the process share, made at its first use.
std::shared_ptr<const Instance> kept_instance();

DeviceEntry describe(const vk::raii::PhysicalDevice& device);

// The first queue family that computes, if any does.
std::optional<std::uint32_t> compute_family(const vk::raii::PhysicalDevice& device);

// The number of the device that is wanted. Throws Unavailable.
std::size_t choose_device(const Instance& instance, std::string_view wanted);

// With one queue of the family.
vk::raii::Device make_device(const vk::raii::PhysicalDevice& physical, std::uint32_t family,
                             const Validation* validation);

}  // namespace lacuna::vulkan
