// The queue of an OpenCL device.
#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "backends/opencl/device.h"

namespace lacuna::opencl {
namespace {

using device::Buffer;
using device::HostMemory;
using device::KernelShape;

constexpr std::uint32_t kProcessorChunks = 32;  // for each core: many, for an even load
constexpr std::uint32_t kLongestChunk = 1024;   // so that a slice of a launch has many chunks
constexpr std::uint32_t kGraphicsGroup = 64;
constexpr std::size_t kFillWords = std::size_t{1} << 16;

class Queue : public device::Queue {
public:
    Queue(std::shared_ptr<Device> device, const std::vector<std::string>& sources)
        : device_(std::move(device)), tried_(sources), sources_(tried_.begin(), tried_.end()) {
        guard([&] {
            queue_ = cl::CommandQueue(device_->context(), device_->device());
            const bool processor = device_->entry().kind == "cpu";
            const auto largest = device_->device().getInfo<CL_DEVICE_MAX_WORK_GROUP_SIZE>();
            const auto units = device_->device().getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>();
            // One size for all launches: PoCL compiles a kernel anew for each.
            if (!processor)
                group_size_ =
                    static_cast<std::uint32_t>(std::min<std::size_t>(kGraphicsGroup, largest));
            chunks_ = processor ? units * kProcessorChunks : 0;
        });
    }
    ~Queue() override { give_turn_back(); }
    Queue(const Queue&) = delete;
    Queue& operator=(const Queue&) = delete;

    const DeviceEntry& device() const override { return device_->entry(); }

    Buffer make(std::uint64_t bytes) override {
        return guard([&] {
            const auto size = static_cast<std::size_t>(std::max<std::uint64_t>(bytes, 4));
            return Buffer(std::make_shared<cl::Buffer>(device_->context(), CL_MEM_READ_WRITE, size),
                          bytes);
        });
    }

    // Memory that the driver has pinned: a card's copies of other memory go through some of its
    // own.
    HostMemory host_memory(std::uint64_t bytes) override {
        try {
            return device::HostMemoryPool::take(device_->host_memory(), bytes,
                                                [&] { return pinned_memory(bytes); });
        } catch (const DeviceError&) {  // no more memory can be pinned: other memory does, too
            return device::Queue::host_memory(bytes);
        }
    }

    void fill(const Buffer& buffer, std::uint32_t value, std::uint64_t words) override {
        if (words == 0) return;
        if (!device_->is_oclgrind())
            return guard(
                [&] { queue_.enqueueFillBuffer(of(buffer), value, 0, words * device::kWord); });
        // Oclgrind regards memory that clEnqueueFillBuffer fills as uninitialized.
        const auto& some = filling_.emplace_back(std::min<std::uint64_t>(words, kFillWords), value);
        for (std::uint64_t at = 0; at < words; at += some.size()) {
            const std::uint64_t count = std::min<std::uint64_t>(some.size(), words - at);
            upload(buffer, std::as_bytes(std::span(some).first(count)), at * device::kWord);
        }
    }

    std::uint32_t run_of(std::uint32_t amount) const override {
        return chunks_ == 0 ? 1 : std::clamp(amount / chunks_, 1u, kLongestChunk);
    }
    bool runs_in_lockstep() const override { return chunks_ == 0; }

    void time_kernels() override {
        guard([&] {
            queue_.finish();
            queue_ = cl::CommandQueue(device_->context(), device_->device(),
                                      cl::QueueProperties::Profiling);
        });
        times_kernels_ = true;
    }

    void drain() noexcept override {
        try {
            queue_.finish();
        } catch (const cl::Error&) {  // not reported here: the run throws its errors
        }
        give_turn_back();
    }

protected:
    void enqueue_upload(const Buffer& to, std::span<const std::byte> from,
                        std::uint64_t offset) override {
        guard(
            [&] { queue_.enqueueWriteBuffer(of(to), CL_FALSE, offset, from.size(), from.data()); });
    }

    void enqueue_download(const Buffer& from, std::span<std::byte> to) override {
        guard([&] { queue_.enqueueReadBuffer(of(from), CL_FALSE, 0, to.size(), to.data()); });
    }

    std::uint32_t group_size() const override { return group_size_; }
    std::uint64_t most_groups() const override {
        return std::numeric_limits<std::uint32_t>::max() / group_size_;
    }

    void enqueue(const KernelShape& shape, std::span<const std::byte> arguments,
                 std::span<const Buffer> buffers, std::uint32_t groups,
                 std::size_t number) override {
        if (device_->entry().kind == "cpu" && !has_turn_) {
            device_->turns().take();
            has_turn_ = true;
        }
        guard([&] {
            cl::Kernel& kernel = kernels_[shape.name];
            if (kernel() == nullptr) kernel = made(shape.name);
            kernel.setArg(0, arguments.size(), arguments.data());
            for (cl_uint i = 0; i < buffers.size(); ++i) kernel.setArg(i + 1, of(buffers[i]));
            queue_.enqueueNDRangeKernel(kernel, cl::NullRange,
                                        cl::NDRange(std::size_t{groups} * group_size_),
                                        cl::NDRange(group_size_), nullptr, &last_);
            if (times_kernels_) launched_.emplace_back(number, last_);
        });
    }

    // Waits for all but the latest slice, so that the device stays busy.
    void pause() override {
        guard([&] {
            queue_.flush();
            if (before_pause_() != nullptr) before_pause_.wait();
            before_pause_ = last_;
        });
    }

    void finish() override {
        guard([&] {
            queue_.finish();
            for (const auto& [number, launch] : std::exchange(launched_, {}))
                add_seconds(number, seconds_of(launch));
        });
        give_turn_back();
        filling_.clear();
        before_pause_ = cl::Event();
    }

    // Uploads read the host's memory until they are done, and it may be freed after the error.
    void discard() override { drain(); }

private:
    static const cl::Buffer& of(const Buffer& buffer) {
        return *static_cast<const cl::Buffer*>(buffer.handle());
    }

    static double seconds_of(const cl::Event& launch) {
        constexpr double kNanosecond = 1e-9;
        return kNanosecond *
               static_cast<double>(launch.getProfilingInfo<CL_PROFILING_COMMAND_END>() -
                                   launch.getProfilingInfo<CL_PROFILING_COMMAND_START>());
    }

    HostMemory pinned_memory(std::uint64_t bytes) {
        return guard([&] {
            const auto size = static_cast<std::size_t>(std::max<std::uint64_t>(bytes, 4));
            const cl::Buffer pinned(device_->context(), CL_MEM_READ_WRITE | CL_MEM_ALLOC_HOST_PTR,
                                    size);
            auto* const memory = static_cast<std::byte*>(
                queue_.enqueueMapBuffer(pinned, CL_TRUE, CL_MAP_READ | CL_MAP_WRITE, 0, size));
            const auto unmap = [queue = queue_, pinned](void* mapped) {
                try {
                    queue.enqueueUnmapMemObject(pinned, mapped);
                    queue.finish();
                } catch (const cl::Error&) {  // the memory is not used again
                }
            };
            return HostMemory(std::shared_ptr<void>(memory, unmap), {memory, size});
        });
    }

    // Prefers a source that was used before: a kernel of all modes is in several sources.
    cl::Kernel made(std::string_view name) {
        std::string_view source = source_of(name, sources_);
        if (source.empty()) {
            source = source_of(name, kernel_sources());
            sources_.push_back(source);
        }
        return cl::Kernel(device_->compiled(source), std::string(name).c_str());
    }

    void give_turn_back() noexcept {
        if (has_turn_) device_->turns().give_back();
        has_turn_ = false;
    }

    template <typename Work>
    std::invoke_result_t<Work> guard(Work work) const {
        return device_->guard(work);
    }

    std::shared_ptr<Device> device_;
    std::vector<std::string> tried_;
    std::vector<std::string_view> sources_;  // of tests, then of kernels made; searched first
    cl::CommandQueue queue_;
    bool has_turn_ = false;
    std::uint32_t group_size_ = 1;
    std::uint32_t chunks_ = 0;  // 0: one for each unit of work
    std::map<std::string_view, cl::Kernel> kernels_;
    cl::Event last_, before_pause_;
    bool times_kernels_ = false;
    std::vector<std::pair<std::size_t, cl::Event>> launched_;  // by kernel, until finish()
    std::vector<std::vector<std::uint32_t>> filling_;          // uploads of fill() under way
};

}  // namespace

std::unique_ptr<device::Queue> make_queue(std::shared_ptr<Device> device,
                                          const std::vector<std::string>& sources) {
    return std::make_unique<Queue>(std::move(device), sources);
}

}  // namespace lacuna::opencl
