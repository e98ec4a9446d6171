// The Vulkan loader, its devices, and the validation layer.
#include "backends/vulkan/instance.h"

#include <lacuna/lacuna.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <string>
#include <string_view>

#include "backends/device/choice.h"
#include "backends/device/kernels.h"
#include "backends/vulkan/vulkan_backend.h"

namespace lacuna::vulkan {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";
constexpr std::uint32_t kVersion = VK_API_VERSION_1_2;

vk::raii::Context load() {
    try {
        return {};
    } catch (const std::exception&) {
        throw Unavailable("backend vulkan: the Vulkan loader libvulkan.so.1 is not installed");
    }
}

// A template, because the headers of Vulkan 1.3.304 and later declare the callback with types of
// namespace vk, and earlier ones with the types of C.
template <class Severity, class Types, class Data>
VKAPI_ATTR VkBool32 VKAPI_CALL pass_on(Severity, Types, const Data* data, void* validation) {
    const std::string id = data->pMessageIdName == nullptr ? "no id" : data->pMessageIdName;
    static_cast<const Validation*>(validation)->report(id + ": " + data->pMessage);
    return VK_FALSE;
}

vk::DebugUtilsMessengerCreateInfoEXT messenger_info(const Validation& validation) {
    using Severity = vk::DebugUtilsMessageSeverityFlagBitsEXT;
    vk::DebugUtilsMessengerCreateInfoEXT info;
    info.messageSeverity = Severity::eWarning | Severity::eError;
    info.messageType = vk::DebugUtilsMessageTypeFlagBitsEXT::eValidation;
    info.pfnUserCallback = pass_on;
    info.pUserData = const_cast<Validation*>(&validation);
    return info;
}

vk::raii::Instance make_instance(const vk::raii::Context& context) {
    const vk::ApplicationInfo application("lacuna", 0, nullptr, 0, kVersion);
    return {context, vk::InstanceCreateInfo({}, &application)};
}

vk::raii::Instance make_validated(const vk::raii::Context& context, const Validation& validation) {
    const auto layers = context.enumerateInstanceLayerProperties();
    if (std::none_of(layers.begin(), layers.end(), [](const vk::LayerProperties& layer) {
            return std::string_view(layer.layerName) == kValidationLayer;
        }))
        throw Unavailable("backend vulkan: the layer " + std::string(kValidationLayer) +
                          " is not installed");

    const bool gpu_assisted = validation.checks == Checks::gpu_assisted;
    const vk::ValidationFeatureEnableEXT enabled =
        gpu_assisted ? vk::ValidationFeatureEnableEXT::eGpuAssisted
                     : vk::ValidationFeatureEnableEXT::eSynchronizationValidation;
    const std::array disabled{vk::ValidationFeatureDisableEXT::eCoreChecks};
    vk::ValidationFeaturesEXT features(enabled);
    if (gpu_assisted) features.setDisabledValidationFeatures(disabled);
    features.pNext = nullptr;

    // A messenger in the chain also receives messages about the creation of the instance.
    vk::DebugUtilsMessengerCreateInfoEXT messenger = messenger_info(validation);
    messenger.pNext = &features;
    const std::array extensions{VK_EXT_DEBUG_UTILS_EXTENSION_NAME,
                                VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME};
    const std::array wanted_layers{kValidationLayer};
    const vk::ApplicationInfo application("lacuna", 0, nullptr, 0, kVersion);
    vk::InstanceCreateInfo info({}, &application, wanted_layers, extensions);
    info.pNext = &messenger;
    return {context, info};
}

bool is_unavailable(vk::Result result) {
    return result == vk::Result::eErrorIncompatibleDriver ||
           result == vk::Result::eErrorInitializationFailed;
}

std::string kind_of(vk::PhysicalDeviceType type) {
    switch (type) {
        case vk::PhysicalDeviceType::eCpu:
            return "cpu";
        case vk::PhysicalDeviceType::eDiscreteGpu:
        case vk::PhysicalDeviceType::eIntegratedGpu:
        case vk::PhysicalDeviceType::eVirtualGpu:
            return "gpu";
        default:
            return "other";
    }
}

std::string version(std::uint32_t api) {
    std::string text = std::to_string(VK_API_VERSION_MAJOR(api));
    text += ".";
    text += std::to_string(VK_API_VERSION_MINOR(api));
    return text;
}

std::uint64_t largest_device_heap(const vk::PhysicalDeviceMemoryProperties& memory) {
    std::uint64_t largest = 0;
    for (std::uint32_t i = 0; i < memory.memoryHeapCount; ++i)
        if (memory.memoryHeaps[i].flags & vk::MemoryHeapFlagBits::eDeviceLocal)
            largest = std::max(largest, std::uint64_t{memory.memoryHeaps[i].size});
    return largest;
}

}  // namespace

Instance::Instance(const Validation* validation) : context_(load()) {
    try {
        instance_ =
            validation == nullptr ? make_instance(context_) : make_validated(context_, *validation);
        if (validation != nullptr) messenger_.emplace(*instance_, messenger_info(*validation));
        devices_ = instance_->enumeratePhysicalDevices();
    } catch (const vk::SystemError& error) {
        if (is_unavailable(static_cast<vk::Result>(error.code().value())))
            throw Unavailable("backend vulkan: no driver is installed (" +
                              std::string(error.what()) + ")");
        throw DeviceError("backend vulkan: " + std::string(error.what()));
    }
}

std::shared_ptr<const Instance> kept_instance() {
    const std::string forked = device::why_forked();
    if (!forked.empty()) throw Unavailable("backend vulkan: " + forked);
    static std::mutex mutex;
    // Never destroyed: by the end of the process a driver may have destroyed itself.
    static auto& kept = *std::make_unique<std::shared_ptr<const Instance>>().release();
    const std::lock_guard lock(mutex);
    if (kept == nullptr) kept = std::make_shared<const Instance>(nullptr);
    return kept;
}

std::optional<std::uint32_t> compute_family(const vk::raii::PhysicalDevice& device) {
    const auto families = device.getQueueFamilyProperties();
    for (std::uint32_t i = 0; i < families.size(); ++i)
        if (families[i].queueFlags & vk::QueueFlagBits::eCompute) return i;
    return std::nullopt;
}

vk::raii::Device make_device(const vk::raii::PhysicalDevice& physical, std::uint32_t family,
                             const Validation* validation) {
    vk::PhysicalDeviceFeatures features;
    features.shaderInt64 = true;
    if (validation != nullptr && validation->checks == Checks::gpu_assisted) {
        // The validation layer's own shader code writes its findings to a buffer.
        const vk::PhysicalDeviceFeatures all = physical.getFeatures();
        features.fragmentStoresAndAtomics = all.fragmentStoresAndAtomics;
        features.vertexPipelineStoresAndAtomics = all.vertexPipelineStoresAndAtomics;
    }
    const float priority = 1.0f;
    const vk::DeviceQueueCreateInfo queue({}, family, 1, &priority);
    return {physical, vk::DeviceCreateInfo({}, queue, {}, {}, &features)};
}

std::size_t choose_device(const Instance& instance, std::string_view wanted) {
    std::vector<DeviceEntry> entries;
    for (const auto& device : instance.devices()) entries.push_back(describe(device));
    return device::choose("vulkan", entries, wanted);
}

DeviceEntry describe(const vk::raii::PhysicalDevice& device) {
    const auto properties = device.getProperties();
    const auto features = device.getFeatures();
    DeviceEntry entry;
    entry.name = properties.deviceName.data();
    entry.kind = kind_of(properties.deviceType);
    entry.has_int64 = features.shaderInt64 != 0;
    entry.has_fp64 = features.shaderFloat64 != 0;
    entry.memory_bytes = largest_device_heap(device.getMemoryProperties());
    entry.largest_buffer_bytes = properties.limits.maxStorageBufferRange;

    if (properties.apiVersion < kVersion)
        entry.unusable = "has Vulkan " + version(properties.apiVersion) + ", 1.2 is needed";
    else if (!entry.has_int64)
        entry.unusable = "has no 64-bit integers in shaders (shaderInt64)";
    else if (properties.limits.maxPerStageDescriptorStorageBuffers < device::kMostBuffers)
        entry.unusable = "allows a shader " +
                         std::to_string(properties.limits.maxPerStageDescriptorStorageBuffers) +
                         " buffers, " + std::to_string(device::kMostBuffers) + " are needed";
    else if (!compute_family(device))
        entry.unusable = "has no queue for compute";
    return entry;
}

std::vector<DeviceEntry> list_devices() {
    std::vector<DeviceEntry> entries;
    try {
        for (const auto& device : kept_instance()->devices()) entries.push_back(describe(device));
    } catch (const Unavailable& unavailable) {
        DeviceEntry none;
        none.name = "Vulkan";
        none.kind = "other";
        none.unusable = unavailable.what();
        entries.push_back(none);
    }
    return entries;
}

}  // namespace lacuna::vulkan
