// A Vulkan device at work: buffers, kernels, and a queue of commands.
#include "backends/vulkan/engine.h"

#include <lacuna/lacuna.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "backends/vulkan/instance.h"

namespace lacuna::vulkan {
namespace {

// Lavapipe runs a group on one thread; graphics cards want a few subgroups in one.
constexpr std::uint32_t kGroupSize = 64;
// A desktop driver gives up on a dispatch after some two seconds: so much work stays far below.
constexpr std::uint64_t kWorkPerDispatch = std::uint64_t{1} << 18;
// Between submissions a run can be cancelled.
constexpr std::uint64_t kWorkPerSubmission = std::uint64_t{1} << 20;
constexpr std::uint32_t kSetsPerPool = 64;

constexpr auto kStages =
    vk::PipelineStageFlagBits::eComputeShader | vk::PipelineStageFlagBits::eTransfer;
constexpr auto kWrites = vk::AccessFlagBits::eShaderWrite | vk::AccessFlagBits::eTransferWrite;
constexpr auto kReads = vk::AccessFlagBits::eShaderRead | vk::AccessFlagBits::eTransferRead;

using Properties = vk::MemoryPropertyFlags;
using PropertyBit = vk::MemoryPropertyFlagBits;
constexpr Properties kHost = PropertyBit::eHostVisible | PropertyBit::eHostCoherent;

// What is needed, and what is preferred beyond it.
std::pair<Properties, Properties> properties_of(Engine::Memory memory) {
    switch (memory) {
        case Engine::Memory::device:
            return {PropertyBit::eDeviceLocal, {}};
        case Engine::Memory::upload:
            return {kHost, {}};
        default:
            return {kHost, PropertyBit::eHostCached};
    }
}

std::optional<std::uint32_t> find_memory_type(const vk::PhysicalDeviceMemoryProperties& memory,
                                              std::uint32_t allowed, Properties wanted) {
    for (std::uint32_t i = 0; i < memory.memoryTypeCount; ++i)
        if ((allowed >> i & 1u) != 0 && (memory.memoryTypes[i].propertyFlags & wanted) == wanted)
            return i;
    return std::nullopt;
}

}  // namespace

struct Buffer::Handles {
    vk::raii::DeviceMemory memory;  // goes last
    vk::raii::Buffer buffer;
};

struct Kernel::Handles {
    vk::raii::DescriptorSetLayout set_layout;
    vk::raii::PipelineLayout layout;
    vk::raii::Pipeline pipeline;
};

struct Engine::Impl {
    Impl(std::string_view wanted, const Validation* validation)
        : instance(validation),
          physical(instance.devices()[choose_device(instance, wanted)]),
          entry(describe(physical)) {
        guarded([&] {
            const std::uint32_t family = compute_family(physical).value();
            memory = physical.getMemoryProperties();
            most_groups = physical.getProperties().limits.maxComputeWorkGroupCount[0];
            device.emplace(make_device(physical, family, validation));
            queue.emplace(device->getQueue(family, 0));
            command_pool.emplace(*device, vk::CommandPoolCreateInfo({}, family));
            commands.emplace(std::move(
                device
                    ->allocateCommandBuffers({**command_pool, vk::CommandBufferLevel::ePrimary, 1})
                    .front()));
        });
    }

    template <typename Work>
    std::invoke_result_t<Work> guarded(Work work) const {
        try {
            return work();
        } catch (const vk::SystemError& error) {
            throw DeviceError("device " + entry.name + ": " + error.what());
        }
    }

    vk::raii::CommandBuffer& recording() {
        if (!is_recording) {
            commands->begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
            is_recording = true;
            record_barrier(kStages, kReads | kWrites);  // after the last submission
        }
        return *commands;
    }

    void record_barrier(vk::PipelineStageFlags stages, vk::AccessFlags to) {
        commands->pipelineBarrier(kStages, stages, {}, vk::MemoryBarrier(kWrites, to), {}, {});
    }

    vk::DescriptorSet make_set(const Kernel::Handles& kernel,
                               std::initializer_list<Buffer> buffers);
    void submit();

    Instance instance;
    vk::raii::PhysicalDevice physical;
    DeviceEntry entry;
    vk::PhysicalDeviceMemoryProperties memory;
    std::uint32_t most_groups = 0;
    std::uint64_t dispatches = 0;

    std::optional<vk::raii::Device> device;
    std::optional<vk::raii::Queue> queue;
    std::optional<vk::raii::CommandPool> command_pool;
    std::optional<vk::raii::CommandBuffer> commands;
    bool is_recording = false;
    std::uint64_t work_recorded = 0;
    std::function<bool()> may_go_on;

    std::vector<vk::raii::DescriptorPool> set_pools;
    std::uint32_t sets_used = 0;
    std::vector<Buffer> in_use;  // by commands that have not run yet
};

vk::DescriptorSet Engine::Impl::make_set(const Kernel::Handles& kernel,
                                         std::initializer_list<Buffer> buffers) {
    if (sets_used == set_pools.size() * kSetsPerPool) {
        const vk::DescriptorPoolSize size(vk::DescriptorType::eStorageBuffer,
                                          kSetsPerPool * kMostBuffers);
        set_pools.emplace_back(*device, vk::DescriptorPoolCreateInfo({}, kSetsPerPool, size));
    }
    const vk::DescriptorSetAllocateInfo info(*set_pools[sets_used / kSetsPerPool],
                                             *kernel.set_layout);
    ++sets_used;
    const vk::DescriptorSet set =
        (**device).allocateDescriptorSets(info, *device->getDispatcher()).front();

    std::vector<vk::DescriptorBufferInfo> infos;
    for (const Buffer& buffer : buffers)
        infos.emplace_back(*buffer.handles_->buffer, 0, VK_WHOLE_SIZE);
    device->updateDescriptorSets(
        vk::WriteDescriptorSet(set, 0, 0, vk::DescriptorType::eStorageBuffer, {}, infos), {});
    return set;
}

// Runs what is recorded, and waits for it.
void Engine::Impl::submit() {
    vk::raii::CommandBuffer& all = recording();
    record_barrier(vk::PipelineStageFlagBits::eHost, vk::AccessFlagBits::eHostRead);
    all.end();
    is_recording = false;
    work_recorded = 0;
    if (may_go_on && !may_go_on()) {
        command_pool->reset();
        throw Cancelled();
    }
    queue->submit(vk::SubmitInfo({}, {}, *all));
    queue->waitIdle();
    command_pool->reset();
}

Engine::Engine(std::string_view wanted_device, const Validation* validation)
    : impl_(std::make_unique<Impl>(wanted_device, validation)) {}

Engine::~Engine() = default;  // what has been submitted has been waited for
const DeviceEntry& Engine::device() const {
    return impl_->entry;
}

std::uint64_t Engine::dispatches() const {
    return impl_->dispatches;
}

void Engine::watch(std::function<bool()> may_go_on) {
    impl_->may_go_on = std::move(may_go_on);
}

Buffer Engine::allocate(Memory where, std::uint64_t bytes) {
    return impl_->guarded([&] {
        using Usage = vk::BufferUsageFlagBits;
        const auto usage = Usage::eStorageBuffer | Usage::eTransferSrc | Usage::eTransferDst;
        const auto size = std::max<std::uint64_t>(bytes, 16);  // none may be empty
        vk::raii::Buffer buffer(*impl_->device, vk::BufferCreateInfo({}, size, usage));
        const vk::MemoryRequirements needs = buffer.getMemoryRequirements();
        const auto [needed, preferred] = properties_of(where);
        auto type = find_memory_type(impl_->memory, needs.memoryTypeBits, needed | preferred);
        if (!type) type = find_memory_type(impl_->memory, needs.memoryTypeBits, needed);
        if (!type)
            throw DeviceError("device " + impl_->entry.name + ": no memory is " +
                              vk::to_string(needed));
        vk::raii::DeviceMemory memory(*impl_->device, vk::MemoryAllocateInfo(needs.size, *type));
        buffer.bindMemory(*memory, 0);

        Buffer made;
        made.bytes_ = size;
        if (where != Memory::device) made.mapped_ = memory.mapMemory(0, VK_WHOLE_SIZE);
        made.handles_ = std::make_shared<Buffer::Handles>(
            Buffer::Handles{std::move(memory), std::move(buffer)});
        return made;
    });
}

Kernel Engine::make_kernel(const Program& program) {
    return impl_->guarded([&] {
        const vk::raii::Device& device = *impl_->device;
        constexpr auto kCompute = vk::ShaderStageFlagBits::eCompute;
        std::vector<vk::DescriptorSetLayoutBinding> bindings;
        for (std::uint32_t i = 0; i < program.buffers; ++i)
            bindings.emplace_back(i, vk::DescriptorType::eStorageBuffer, 1, kCompute);
        vk::raii::DescriptorSetLayout sets(device, vk::DescriptorSetLayoutCreateInfo({}, bindings));
        const vk::PushConstantRange arguments(kCompute, 0, program.argument_bytes);
        vk::raii::PipelineLayout layout(device, vk::PipelineLayoutCreateInfo({}, *sets, arguments));

        const vk::raii::ShaderModule shader(
            device,
            vk::ShaderModuleCreateInfo({}, program.spirv.size_bytes(), program.spirv.data()));
        const vk::SpecializationMapEntry entry(0, 0, sizeof(kGroupSize));
        const vk::SpecializationInfo group_size(1, &entry, sizeof(kGroupSize), &kGroupSize);
        const vk::PipelineShaderStageCreateInfo stage({}, kCompute, *shader, "main", &group_size);
        vk::raii::Pipeline pipeline(device, nullptr,
                                    vk::ComputePipelineCreateInfo({}, stage, *layout));
        Kernel kernel;
        kernel.handles_ = std::make_shared<Kernel::Handles>(
            Kernel::Handles{std::move(sets), std::move(layout), std::move(pipeline)});
        return kernel;
    });
}

void Engine::copy(const Buffer& from, const Buffer& to, std::uint64_t bytes,
                  std::uint64_t from_offset, std::uint64_t to_offset) {
    if (bytes == 0) return;
    impl_->guarded([&] {
        impl_->recording().copyBuffer(*from.handles_->buffer, *to.handles_->buffer,
                                      vk::BufferCopy(from_offset, to_offset, bytes));
    });
    impl_->in_use.insert(impl_->in_use.end(), {from, to});
}

void Engine::fill(const Buffer& buffer, std::uint32_t value, std::uint64_t bytes,
                  std::uint64_t offset) {
    impl_->guarded(
        [&] { impl_->recording().fillBuffer(*buffer.handles_->buffer, offset, bytes, value); });
    impl_->in_use.push_back(buffer);
}

void Engine::barrier() {
    impl_->guarded([&] {
        impl_->recording();
        impl_->record_barrier(kStages, kReads | kWrites);
    });
}

void Engine::dispatch_bytes(const Kernel& kernel, std::initializer_list<Buffer> buffers,
                            std::span<const std::byte> arguments, std::uint32_t items,
                            std::uint32_t work) {
    if (items == 0) return;
    impl_->in_use.insert(impl_->in_use.end(), buffers.begin(), buffers.end());
    impl_->guarded([&] {
        constexpr auto kCompute = vk::PipelineBindPoint::eCompute;
        const vk::DescriptorSet set = impl_->make_set(*kernel.handles_, buffers);
        const vk::PipelineLayout layout = *kernel.handles_->layout;
        std::vector<std::byte> pushed(arguments.begin(), arguments.end());
        const std::uint64_t most_groups = std::clamp<std::uint64_t>(
            kWorkPerDispatch / kGroupSize / std::max(work, 1u), 1, impl_->most_groups);
        const auto most = static_cast<std::uint32_t>(most_groups) * kGroupSize;
        for (std::uint32_t first = 0; first < items; first += most) {
            if (impl_->work_recorded >= kWorkPerSubmission) impl_->submit();
            vk::raii::CommandBuffer& commands = impl_->recording();
            commands.bindPipeline(kCompute, *kernel.handles_->pipeline);
            commands.bindDescriptorSets(kCompute, layout, 0, set, {});
            std::memcpy(pushed.data(), &first, sizeof(first));
            commands.pushConstants<std::byte>(layout, vk::ShaderStageFlagBits::eCompute, 0, pushed);
            const std::uint32_t served = std::min(most, items - first);
            commands.dispatch((served + kGroupSize - 1) / kGroupSize, 1, 1);
            impl_->work_recorded += std::uint64_t{served} * work;
            ++impl_->dispatches;
        }
    });
}

void Engine::wait() {
    impl_->guarded([&] {
        impl_->submit();
        for (const auto& pool : impl_->set_pools) pool.reset();
        impl_->sets_used = 0;
    });
    impl_->in_use.clear();
}

}  // namespace lacuna::vulkan
