// A Vulkan device with its queue and pipelines.
#include "backends/vulkan/device.h"

#include <lacuna/lacuna.h>

#include <utility>

#include "backends/vulkan/shaders.h"

namespace lacuna::vulkan {
namespace {

double tick_seconds_of(const vk::raii::PhysicalDevice& physical, std::uint32_t family) {
    constexpr double kNanosecond = 1e-9;
    if (physical.getQueueFamilyProperties()[family].timestampValidBits == 0) return 0;
    return kNanosecond * static_cast<double>(physical.getProperties().limits.timestampPeriod);
}

std::uint64_t tick_mask_of(const vk::raii::PhysicalDevice& physical, std::uint32_t family) {
    constexpr std::uint32_t kAllBits = 64;
    const std::uint32_t bits = physical.getQueueFamilyProperties()[family].timestampValidBits;
    return bits >= kAllBits ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
}

}  // namespace

Device::Device(std::shared_ptr<const Instance> instance, std::size_t number,
               const Validation* validation)
    : instance_(std::move(instance)),
      physical_(instance_->devices()[number]),
      entry_(describe(physical_)),
      family_(compute_family(physical_).value()),
      memory_(physical_.getMemoryProperties()),
      most_groups_(physical_.getProperties().limits.maxComputeWorkGroupCount[0]),
      tick_seconds_(tick_seconds_of(physical_, family_)),
      tick_mask_(tick_mask_of(physical_, family_)),
      device_(guarded([&] { return make_device(physical_, family_, validation); })),
      queue_(device_, family_, 0) {}

const Pipeline& Device::pipeline(const device::KernelShape& kernel) {
    const std::lock_guard lock(pipelines_mutex_);
    const auto found = pipelines_.find(kernel.name);
    if (found != pipelines_.end()) return found->second;
    return pipelines_.emplace(kernel.name, made_pipeline(kernel, embedded_shader(kernel.name)))
        .first->second;
}

Pipeline Device::made_pipeline(const device::KernelShape& kernel,
                               std::span<const std::uint32_t> spirv) const {
    return guarded([&] { return make_pipeline(kernel, spirv); });
}

Pipeline Device::make_pipeline(const device::KernelShape& kernel,
                               std::span<const std::uint32_t> spirv) const {
    constexpr auto kCompute = vk::ShaderStageFlagBits::eCompute;
    std::vector<vk::DescriptorSetLayoutBinding> bindings;
    for (std::uint32_t i = 0; i < kernel.buffers; ++i)
        bindings.emplace_back(i, vk::DescriptorType::eStorageBuffer, 1, kCompute);
    vk::raii::DescriptorSetLayout sets(device_, vk::DescriptorSetLayoutCreateInfo({}, bindings));
    const vk::PushConstantRange arguments(kCompute, 0, kernel.argument_bytes);
    vk::raii::PipelineLayout layout(device_, vk::PipelineLayoutCreateInfo({}, *sets, arguments));

    const vk::raii::ShaderModule shader(
        device_, vk::ShaderModuleCreateInfo({}, spirv.size_bytes(), spirv.data()));
    const vk::SpecializationMapEntry entry(0, 0, sizeof(kGroupSize));
    const vk::SpecializationInfo group_size(1, &entry, sizeof(kGroupSize), &kGroupSize);
    const vk::PipelineShaderStageCreateInfo stage({}, kCompute, *shader, "main", &group_size);
    vk::raii::Pipeline pipeline(device_, nullptr,
                                vk::ComputePipelineCreateInfo({}, stage, *layout));
    return {std::move(sets), std::move(layout), std::move(pipeline)};
}

void Device::run(const vk::raii::CommandBuffer& commands) {
    const std::lock_guard lock(queue_mutex_);
    queue_.submit(vk::SubmitInfo({}, {}, *commands));
    queue_.waitIdle();
}

std::shared_ptr<Device> kept_device(std::string_view wanted) {
    const std::shared_ptr<const Instance> instance = kept_instance();
    static std::mutex mutex;
    // Never destroyed: by the end of the process a driver may have destroyed itself.
    using All = std::map<std::size_t, std::shared_ptr<Device>>;
    static All& all = *std::make_unique<All>().release();
    const std::lock_guard lock(mutex);
    const std::size_t number = choose_device(*instance, wanted);
    std::shared_ptr<Device>& device = all[number];
    if (device == nullptr) device = std::make_shared<Device>(instance, number, nullptr);
    return device;
}

}  // namespace lacuna::vulkan
