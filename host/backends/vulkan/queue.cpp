// The queue of one backend on a Vulkan device: commands are recorded, then submitted and waited
// for.
#include <algorithm>
#include <cstring>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "backends/vulkan/device.h"

namespace lacuna::vulkan {
namespace {

using device::Buffer;
using device::HostMemory;
using device::KernelShape;

constexpr std::uint32_t kServedTogether = 32;  // units of work on a processor, see run_of
constexpr std::uint32_t kSetsPerPool = 64;
constexpr std::uint32_t kMostBuffers = 16;
constexpr std::uint32_t kMostTimes = 4096;  // that are measured in one submission, two a launch
// The least size of a block of the host's memory for transfers, in bytes.
constexpr std::uint64_t kStagingBytes = std::uint64_t{1} << 22;

constexpr auto kStages =
    vk::PipelineStageFlagBits::eComputeShader | vk::PipelineStageFlagBits::eTransfer;
constexpr auto kWrites = vk::AccessFlagBits::eShaderWrite | vk::AccessFlagBits::eTransferWrite;
constexpr auto kReads = vk::AccessFlagBits::eShaderRead | vk::AccessFlagBits::eTransferRead;

using Properties = vk::MemoryPropertyFlags;
using PropertyBit = vk::MemoryPropertyFlagBits;
constexpr Properties kHost = PropertyBit::eHostVisible | PropertyBit::eHostCoherent;

struct Allocation {
    vk::raii::DeviceMemory memory;  // destroyed last
    vk::raii::Buffer buffer;
};

// A stretch of the host's memory that the device copies to or from.
struct Staged {
    vk::Buffer buffer;
    std::uint64_t offset;
    std::byte* bytes;
};

class Queue : public device::Queue {
public:
    Queue(std::shared_ptr<Device> the_device, ShaderOf shader_of)
        : device_(std::move(the_device)),
          shader_of_(std::move(shader_of)),
          pool_(device_->guarded([&] {
              return vk::raii::CommandPool(device_->handle(),
                                           vk::CommandPoolCreateInfo({}, device_->family()));
          })),
          commands_(device_->guarded([&] {
              return std::move(vk::raii::CommandBuffers(
                                   device_->handle(), {*pool_, vk::CommandBufferLevel::ePrimary, 1})
                                   .front());
          })) {}

    const DeviceEntry& device() const override { return device_->entry(); }

    Buffer make(std::uint64_t bytes) override {
        return Buffer(allocate(bytes, PropertyBit::eDeviceLocal, {}), bytes);
    }

    // Memory that the device can copy from and to, so that nothing is copied to staging memory.
    HostMemory host_memory(std::uint64_t bytes) override {
        if (bytes == 0 || bytes > device().largest_buffer_bytes)
            return device::Queue::host_memory(bytes);
        std::erase_if(host_blocks_, [](const HostMemory& block) { return !block.has_copies(); });
        try {
            const HostMemory block =
                device::HostMemoryPool::take(device_->host_memory(), bytes, [&] {
                    const auto allocation =
                        allocate(bytes, kHost | PropertyBit::eHostCached, Properties{});
                    return HostMemory(allocation, mapped(*allocation, bytes));
                });
            return host_blocks_.emplace_back(block);
        } catch (const DeviceError&) {  // no memory is of this kind, or none is left
            return device::Queue::host_memory(bytes);
        }
    }

    void fill(const Buffer& buffer, std::uint32_t value, std::uint64_t words) override {
        if (words == 0) return;
        device_->guarded(
            [&] { recording().fillBuffer(of(buffer), 0, words * device::kWord, value); });
        in_use_.push_back(buffer);
    }

    std::uint32_t run_of(std::uint32_t) const override {
        return device().kind == "cpu" ? kServedTogether : 1;
    }
    bool runs_in_lockstep() const override { return true; }

    void time_kernels() override {
        tick_seconds_ = device_->tick_seconds();
        if (tick_seconds_ == 0) return;
        device_->guarded([&] {
            times_.emplace(device_->handle(),
                           vk::QueryPoolCreateInfo({}, vk::QueryType::eTimestamp, kMostTimes));
        });
    }
    void drain() noexcept override {}  // submit() has waited already

protected:
    void enqueue_upload(const Buffer& to, std::span<const std::byte> from,
                        std::uint64_t offset) override {
        std::optional<Staged> staged = staged_already(from);
        if (!staged) {
            staged = up_.take(*this, from.size());
            std::memcpy(staged->bytes, from.data(), from.size());
        }
        device_->guarded([&] {
            recording().copyBuffer(staged->buffer, of(to),
                                   vk::BufferCopy(staged->offset, offset, from.size()));
        });
        in_use_.push_back(to);
    }

    void enqueue_download(const Buffer& from, std::span<std::byte> to) override {
        const std::optional<Staged> known = staged_already(to);
        const Staged staged = known ? *known : down_.take(*this, to.size());
        device_->guarded([&] {
            recording().copyBuffer(of(from), staged.buffer,
                                   vk::BufferCopy(0, staged.offset, to.size()));
        });
        in_use_.push_back(from);
        if (!known) arriving_.push_back({staged.bytes, to});
    }

    std::uint32_t group_size() const override { return kGroupSize; }
    std::uint64_t most_groups() const override { return device_->most_groups(); }

    void enqueue(const KernelShape& kernel, std::span<const std::byte> arguments,
                 std::span<const Buffer> buffers, std::uint32_t groups,
                 std::size_t number) override {
        in_use_.insert(in_use_.end(), buffers.begin(), buffers.end());
        const Pipeline& pipeline = pipeline_of(kernel);
        device_->guarded([&] {
            constexpr auto kCompute = vk::PipelineBindPoint::eCompute;
            const vk::DescriptorSet set = make_set(pipeline, buffers);
            vk::raii::CommandBuffer& commands = recording();
            commands.bindPipeline(kCompute, *pipeline.pipeline);
            commands.bindDescriptorSets(kCompute, *pipeline.layout, 0, set, {});
            commands.pushConstants<std::byte>(*pipeline.layout, vk::ShaderStageFlagBits::eCompute,
                                              0, arguments);
            write_time(number);
            commands.dispatch(groups, 1, 1);
            write_time(number);
        });
    }

    void pause() override { submit(); }

    void finish() override {
        submit();
        for (const auto& [from, to] : arriving_) std::memcpy(to.data(), from, to.size());
        let_go();
    }

    void discard() override {
        device_->guarded([&] { pool_.reset(); });
        is_recording_ = false;
        timed_.clear();
        let_go();
    }

private:
    // The host's memory for transfers: handed out in pieces, and given back all at once.
    class Staging {
    public:
        explicit Staging(Properties preferred) : preferred_(preferred) {}

        Staged take(Queue& queue, std::uint64_t bytes) {
            if (blocks_.empty() || blocks_.back().used + bytes > blocks_.back().bytes) {
                const std::uint64_t size = std::max(bytes, kStagingBytes);
                auto allocation = queue.allocate(size, kHost, preferred_);
                std::byte* const bytes_of_block = queue.mapped(*allocation, size).data();
                blocks_.push_back({std::move(allocation), bytes_of_block, size});
            }
            Block& block = blocks_.back();
            const Staged staged{*block.allocation->buffer, block.used, block.mapped + block.used};
            block.used += (bytes + 15) / 16 * 16;
            return staged;
        }

        // Keeps only the block that was made last.
        void give_back() {
            while (blocks_.size() > 1) blocks_.pop_front();
            if (!blocks_.empty()) blocks_.front().used = 0;
        }

    private:
        struct Block {
            std::shared_ptr<Allocation> allocation;
            std::byte* mapped;
            std::uint64_t bytes;
            std::uint64_t used = 0;
        };
        Properties preferred_;
        std::deque<Block> blocks_;
    };

    std::span<std::byte> mapped(const Allocation& allocation, std::uint64_t bytes) const {
        return device_->guarded([&] {
            return std::span(static_cast<std::byte*>(allocation.memory.mapMemory(0, VK_WHOLE_SIZE)),
                             static_cast<std::size_t>(bytes));
        });
    }

    // Where the bytes lie in a block of host_memory(), if they do.
    std::optional<Staged> staged_already(std::span<const std::byte> bytes) const {
        for (const HostMemory& block : host_blocks_) {
            if (!block.contains(bytes)) continue;
            std::byte* const first = block.values<std::byte>(1).data();
            const auto offset = static_cast<std::uint64_t>(bytes.data() - first);
            const auto& allocation = *static_cast<const Allocation*>(block.handle());
            return Staged{*allocation.buffer, offset, first + offset};
        }
        return std::nullopt;
    }

    struct Arriving {
        const std::byte* from;
        std::span<std::byte> to;
    };

    const Pipeline& pipeline_of(const KernelShape& kernel) {
        const auto found = tried_.find(kernel.name);
        if (found != tried_.end()) return found->second;
        const std::vector<std::uint32_t> spirv =
            shader_of_ ? shader_of_(kernel.name) : std::vector<std::uint32_t>{};
        if (spirv.empty()) return device_->pipeline(kernel);
        return tried_.emplace(kernel.name, device_->made_pipeline(kernel, spirv)).first->second;
    }

    static vk::Buffer of(const Buffer& buffer) {
        return *static_cast<const Allocation*>(buffer.handle())->buffer;
    }

    std::shared_ptr<Allocation> allocate(std::uint64_t bytes, Properties needed,
                                         Properties preferred) {
        return device_->guarded([&] {
            using Usage = vk::BufferUsageFlagBits;
            const auto usage = Usage::eStorageBuffer | Usage::eTransferSrc | Usage::eTransferDst;
            const auto size = std::max<std::uint64_t>(bytes, 16);  // no buffer may be empty
            vk::raii::Buffer buffer(device_->handle(), vk::BufferCreateInfo({}, size, usage));
            const vk::MemoryRequirements needs = buffer.getMemoryRequirements();
            const auto& types = device_->memory();
            auto type = find_type(types, needs.memoryTypeBits, needed | preferred);
            if (!type) type = find_type(types, needs.memoryTypeBits, needed);
            if (!type)
                throw DeviceError("device " + device().name + ": no memory is " +
                                  vk::to_string(needed));
            vk::raii::DeviceMemory memory(device_->handle(),
                                          vk::MemoryAllocateInfo(needs.size, *type));
            buffer.bindMemory(*memory, 0);
            return std::make_shared<Allocation>(Allocation{std::move(memory), std::move(buffer)});
        });
    }

    static std::optional<std::uint32_t> find_type(const vk::PhysicalDeviceMemoryProperties& memory,
                                                  std::uint32_t allowed, Properties wanted) {
        for (std::uint32_t i = 0; i < memory.memoryTypeCount; ++i)
            if ((allowed >> i & 1u) != 0 &&
                (memory.memoryTypes[i].propertyFlags & wanted) == wanted)
                return i;
        return std::nullopt;
    }

    // Returns the buffer for the next command, which sees the results of all earlier ones.
    vk::raii::CommandBuffer& recording() {
        if (!is_recording_) commands_.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
        is_recording_ = true;
        record_barrier(kStages, kReads | kWrites);
        return commands_;
    }
    void record_barrier(vk::PipelineStageFlags stages, vk::AccessFlags to) {
        commands_.pipelineBarrier(kStages, stages, {}, vk::MemoryBarrier(kWrites, to), {}, {});
    }

    vk::DescriptorSet make_set(const Pipeline& pipeline, std::span<const Buffer> buffers) {
        if (sets_used_ == set_pools_.size() * kSetsPerPool) {
            const vk::DescriptorPoolSize size(vk::DescriptorType::eStorageBuffer,
                                              kSetsPerPool * kMostBuffers);
            set_pools_.emplace_back(device_->handle(),
                                    vk::DescriptorPoolCreateInfo({}, kSetsPerPool, size));
        }
        const vk::DescriptorSetAllocateInfo info(*set_pools_[sets_used_ / kSetsPerPool],
                                                 *pipeline.set_layout);
        ++sets_used_;
        const vk::raii::Device& device = device_->handle();
        const vk::DescriptorSet set =
            (*device).allocateDescriptorSets(info, *device.getDispatcher()).front();
        std::vector<vk::DescriptorBufferInfo> infos;
        for (const Buffer& buffer : buffers) infos.emplace_back(of(buffer), 0, VK_WHOLE_SIZE);
        device.updateDescriptorSets(
            vk::WriteDescriptorSet(set, 0, 0, vk::DescriptorType::eStorageBuffer, {}, infos), {});
        return set;
    }

    // Writes the time when all commands so far are done, once before a launch and once after it.
    // The commands of one submission that are beyond the room for times are not measured.
    void write_time(std::size_t number) {
        if (!times_ || timed_.size() == kMostTimes) return;
        if (timed_.empty()) commands_.resetQueryPool(**times_, 0, kMostTimes);
        commands_.writeTimestamp(vk::PipelineStageFlagBits::eBottomOfPipe, **times_,
                                 static_cast<std::uint32_t>(timed_.size()));
        timed_.push_back(number);
    }

    void read_times() {
        if (timed_.empty()) return;
        const auto count = static_cast<std::uint32_t>(timed_.size());
        const auto [result, ticks] = times_->getResults<std::uint64_t>(
            0, count, count * sizeof(std::uint64_t), sizeof(std::uint64_t),
            vk::QueryResultFlagBits::e64 | vk::QueryResultFlagBits::eWait);
        for (std::size_t i = 1; i < ticks.size(); i += 2)
            add_seconds(timed_[i], tick_seconds_ * static_cast<double>((ticks[i] - ticks[i - 1]) &
                                                                       device_->tick_mask()));
        timed_.clear();
    }

    // Runs what is recorded, and waits for it.
    void submit() {
        device_->guarded([&] {
            recording();
            record_barrier(vk::PipelineStageFlagBits::eHost, vk::AccessFlagBits::eHostRead);
            commands_.end();
            is_recording_ = false;
            device_->run(commands_);
            read_times();
            pool_.reset();
        });
    }

    void let_go() {
        device_->guarded([&] {
            for (const auto& pool : set_pools_) pool.reset();
        });
        sets_used_ = 0;
        in_use_.clear();
        arriving_.clear();
        up_.give_back();
        down_.give_back();
    }

    std::shared_ptr<Device> device_;
    ShaderOf shader_of_;                          // a test's
    std::map<std::string_view, Pipeline> tried_;  // of its shaders
    vk::raii::CommandPool pool_;
    vk::raii::CommandBuffer commands_;
    bool is_recording_ = false;

    std::vector<vk::raii::DescriptorPool> set_pools_;
    std::uint32_t sets_used_ = 0;
    std::vector<Buffer> in_use_;  // by commands that have not run
    Staging up_{Properties{}};
    Staging down_{PropertyBit::eHostCached};
    std::vector<Arriving> arriving_;
    std::vector<HostMemory> host_blocks_;

    std::optional<vk::raii::QueryPool> times_;  // with time_kernels()
    std::vector<std::size_t> timed_;            // the kernel of each time that is written
    double tick_seconds_ = 0;
};

}  // namespace

std::unique_ptr<device::Queue> make_queue(std::shared_ptr<Device> device, ShaderOf shader_of) {
    return std::make_unique<Queue>(std::move(device), std::move(shader_of));
}

}  // namespace lacuna::vulkan
