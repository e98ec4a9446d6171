// A device as Lacuna sees it: memory, and a queue of a few commands. OpenCL and Vulkan implement
// it.
#pragma once

#include <lacuna/lacuna.h>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "backends/device/choice.h"

namespace lacuna::device {

inline constexpr std::uint64_t kWord = sizeof(std::uint32_t);

// Memory on the device. Copies refer to the same memory; a queue keeps what its commands need.
class Buffer {
public:
    Buffer() = default;
    Buffer(std::shared_ptr<void> handle, std::uint64_t bytes)
        : handle_(std::move(handle)), bytes_(bytes) {}

    std::uint64_t bytes() const { return bytes_; }
    // The room in words; 0 before the buffer is made.
    std::uint64_t words() const { return bytes_ / kWord; }
    void* handle() const { return handle_.get(); }

private:
    std::shared_ptr<void> handle_;
    std::uint64_t bytes_ = 0;
};

// Memory of the host for transfers. Where a device can read and write the host's memory itself, it
// does so with this memory, and the driver copies nothing. Copies refer to the same memory.
class HostMemory {
public:
    HostMemory() = default;
    HostMemory(std::shared_ptr<void> handle, std::span<std::byte> bytes)
        : handle_(std::move(handle)), bytes_(bytes) {}

    std::uint64_t bytes() const { return bytes_.size(); }
    void* handle() const { return handle_.get(); }
    bool has_copies() const { return handle_.use_count() > 1; }
    bool contains(std::span<const std::byte> other) const {
        const std::less_equal<> is_at_most;
        return is_at_most(bytes_.data(), other.data()) &&
               is_at_most(other.data() + other.size(), bytes_.data() + bytes_.size());
    }
    // `count` values, of which the first is at the byte `offset`. They begin undefined.
    template <typename T>
    std::span<T> values(std::size_t count, std::size_t offset = 0) const {
        static_assert(std::is_trivially_copyable_v<T>);
        return {reinterpret_cast<T*>(bytes_.data() + offset), count};
    }

private:
    std::shared_ptr<void> handle_;
    std::span<std::byte> bytes_;
};

// The host's memory that a device's queues have used: it is given out again, because it takes long
// to make. Holds at most kMostBytes, and is thread-safe.
class HostMemoryPool {
public:
    using Make = std::function<HostMemory()>;

    // Memory of at least `bytes` bytes: some that was given back, otherwise made by `make`.
    static HostMemory take(const std::shared_ptr<HostMemoryPool>& pool, std::uint64_t bytes,
                           const Make& make);

private:
    static constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 28;

    void give_back(HostMemory memory);

    std::mutex mutex_;
    std::vector<HostMemory> free_;
};

// A kernel of portable/kernels.h.
struct KernelShape {
    std::string_view name;
    std::uint32_t buffers;
    std::uint32_t argument_bytes;
};

// Commands run in order, and each sees the results of earlier ones. They may begin only in wait().
// All calls throw DeviceError, which names the device, the call and the driver's log.
class Queue {
public:
    virtual ~Queue() = default;

    virtual const DeviceEntry& device() const = 0;
    // Makes a buffer of at least `bytes` bytes, whose content is undefined.
    virtual Buffer make(std::uint64_t bytes) = 0;
    // Makes memory of at least `bytes` bytes for upload() and download(), which take any other,
    // too.
    virtual HostMemory host_memory(std::uint64_t bytes);
    // Sets the first words.
    virtual void fill(const Buffer& buffer, std::uint32_t value, std::uint64_t words) = 0;
    // `from` must stay as it is until wait() returns.
    void upload(const Buffer& to, std::span<const std::byte> from, std::uint64_t offset);
    // `to` is filled when wait() returns.
    void download(const Buffer& from, std::span<std::byte> to);

    // The number of consecutive units of work, out of `amount`, that an item serves if each unit
    // continues from the one before: many on a processor, 1 on a graphics card.
    virtual std::uint32_t run_of(std::uint32_t amount) const = 0;
    // Whether neighbouring items run in lockstep, and so should do similar work.
    virtual bool runs_in_lockstep() const = 0;
    // The number of units that an item serves where each unit is independent.
    std::uint32_t chunk_of(std::uint32_t amount) const {
        return runs_in_lockstep() ? 1 : run_of(amount);
    }

    // Runs the kernel for items 0, 1, ... `items` - 1 and perhaps some more. `work` estimates an
    // item's time in tenths of a microsecond: long work is cut into slices, between which the run
    // can be cancelled. `arguments` begin with the number of the first item, which is filled in.
    void launch(const KernelShape& kernel, std::span<std::byte> arguments,
                std::span<const Buffer> buffers, std::uint64_t items, std::uint64_t work);
    // Completes the queued commands. Throws Cancelled.
    void wait();
    // Waits for commands that have begun, even after errors: then no transfer is under way.
    virtual void drain() noexcept = 0;
    // Asked before each wait and between slices; false cancels the run.
    void watch(std::function<bool()> may_go_on) { may_go_on_ = std::move(may_go_on); }
    // What this queue was asked to do so far.
    const Work& work() const { return work_; }
    // Measures from now on how long each kernel takes, if the device has a clock for it.
    virtual void time_kernels() = 0;

protected:
    virtual void enqueue_upload(const Buffer& to, std::span<const std::byte> from,
                                std::uint64_t offset) = 0;
    virtual void enqueue_download(const Buffer& from, std::span<std::byte> to) = 0;
    // Items come in groups of this size.
    virtual std::uint32_t group_size() const = 0;
    virtual std::uint64_t most_groups() const = 0;
    // `number` is the kernel's, for add_seconds().
    virtual void enqueue(const KernelShape& kernel, std::span<const std::byte> arguments,
                         std::span<const Buffer> buffers, std::uint32_t groups,
                         std::size_t number) = 0;
    void add_seconds(std::size_t number, double seconds) {
        work_.kernels[number].seconds += seconds;
    }
    // Begins the queued commands. Waits for all, except perhaps those after the last pause.
    virtual void pause() = 0;
    virtual void finish() = 0;
    // Drops queued commands that have not begun.
    virtual void discard() {}

private:
    void ask();
    std::size_t number_of(std::string_view kernel);

    std::function<bool()> may_go_on_;
    Work work_;
    std::uint64_t queued_ = 0;  // work since the last pause
};

// Most turns that an item's loops take together: lavapipe ends loops after 65,535.
inline constexpr std::uint32_t kMostTurns = 1u << 14;

// The number of items that serve `amount` units of work in chunks.
inline std::uint64_t items_of(std::uint64_t amount, std::uint32_t chunk) {
    return (amount + chunk - 1) / chunk;
}

// The error for a job whose kernel could not finish its loops (portable/failure.h).
DeviceError ended_early(const DeviceEntry& device, const std::string& job);

}  // namespace lacuna::device
