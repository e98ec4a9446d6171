// A Vulkan device with its queue and pipelines: made once and kept for the process. Includes all of
// Vulkan's C++ headers, which take seconds to compile: for this folder's .cpp files only.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>
#include <vulkan/vulkan_raii.hpp>

#include "backends/device/choice.h"
#include "backends/device/queue.h"
#include "backends/vulkan/instance.h"
#include "backends/vulkan/vulkan_backend.h"

namespace lacuna::vulkan {

// Items of a work group: lavapipe runs a group on one thread, graphics cards want a few subgroups.
inline constexpr std::uint32_t kGroupSize = 64;

struct Pipeline {
    vk::raii::DescriptorSetLayout set_layout;
    vk::raii::PipelineLayout layout;
    vk::raii::Pipeline pipeline;
};

class Device {
public:
    Device(std::shared_ptr<const Instance> instance, std::size_t number,
           const Validation* validation);

    const DeviceEntry& entry() const { return entry_; }
    const vk::raii::Device& handle() const { return device_; }
    std::uint32_t family() const { return family_; }
    const vk::PhysicalDeviceMemoryProperties& memory() const { return memory_; }
    std::uint64_t most_groups() const { return most_groups_; }
    const std::shared_ptr<device::HostMemoryPool>& host_memory() const { return host_memory_; }
    // The unit of times that its queue writes; 0 if it writes none. They count up to a mask, and
    // begin again.
    double tick_seconds() const { return tick_seconds_; }
    std::uint64_t tick_mask() const { return tick_mask_; }

    // A pipeline is made at its first use; its address stays valid. Like run(), thread-safe.
    const Pipeline& pipeline(const device::KernelShape& kernel);
    Pipeline made_pipeline(const device::KernelShape& kernel,
                           std::span<const std::uint32_t> spirv) const;
    // Submits the commands and waits for them.
    void run(const vk::raii::CommandBuffer& commands);

    // Vulkan's errors become Lacuna's.
    template <typename Work>
    std::invoke_result_t<Work> guarded(Work work) const {
        try {
            return work();
        } catch (const vk::SystemError& error) {
            throw DeviceError("device " + entry_.name + ": " + error.what());
        }
    }

private:
    Pipeline make_pipeline(const device::KernelShape& kernel,
                           std::span<const std::uint32_t> spirv) const;

    std::shared_ptr<const Instance> instance_;
    const vk::raii::PhysicalDevice& physical_;
    DeviceEntry entry_;
    std::uint32_t family_;
    vk::PhysicalDeviceMemoryProperties memory_;
    std::uint64_t most_groups_;
    double tick_seconds_;
    std::uint64_t tick_mask_;
    vk::raii::Device device_;
    vk::raii::Queue queue_;
    std::shared_ptr<device::HostMemoryPool> host_memory_ =
        std::make_shared<device::HostMemoryPool>();

    std::mutex pipelines_mutex_;
    std::map<std::string_view, Pipeline> pipelines_;
    std::mutex queue_mutex_;
};

// The wanted device, the same one on every call. Throws Unavailable, DeviceError.
std::shared_ptr<Device> kept_device(std::string_view wanted);

// The queue of one backend on the device, with the shaders of a test.
std::unique_ptr<device::Queue> make_queue(std::shared_ptr<Device> device, ShaderOf shader_of);

}  // namespace lacuna::vulkan
