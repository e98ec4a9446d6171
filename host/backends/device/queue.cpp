// Launches, cut into slices, and waits.
#include "backends/device/queue.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <new>
#include <utility>

namespace lacuna::device {
namespace {

// Work of a slice, in 0.1 microseconds: 52 ms. Callers estimate work too high: slices of half this
// took 1 to 16 ms on average, 28 ms at most, on two threads. Between short slices threads wait for
// each other. A desktop's driver ends a launch after two seconds.
constexpr std::uint64_t kWorkPerSlice = std::uint64_t{1} << 19;
// Work between pauses: with two slices under way, a run is cancelled in a fraction of 0.2 s.
constexpr std::uint64_t kWorkPerPause = std::uint64_t{1} << 20;
// A graphics card does this many times the work in that time: few, so that a small card keeps it,
// too. An H200 is as fast with 16 times as many, and takes over twice as long with a slice of 1.
constexpr std::uint64_t kItemsSideBySide = 256;

}  // namespace

void Queue::ask() {
    if (!may_go_on_ || may_go_on_()) return;
    discard();
    queued_ = 0;
    throw Cancelled();
}

HostMemory HostMemoryPool::take(const std::shared_ptr<HostMemoryPool>& pool, std::uint64_t bytes,
                                const Make& make) {
    const auto fits = [&](const HostMemory& one) { return one.bytes() >= bytes; };
    HostMemory memory;
    {
        const std::lock_guard lock(pool->mutex_);
        const auto found = std::find_if(pool->free_.begin(), pool->free_.end(), fits);
        if (found != pool->free_.end()) {
            memory = std::move(*found);
            pool->free_.erase(found);
        }
    }
    if (memory.bytes() == 0) memory = make();
    const auto give_back = [pool, memory](void*) {
        try {
            pool->give_back(memory);
        } catch (const std::bad_alloc&) {  // then it is not kept
        }
    };
    return {std::shared_ptr<void>(memory.handle(), give_back),
            memory.values<std::byte>(static_cast<std::size_t>(memory.bytes()))};
}

void HostMemoryPool::give_back(HostMemory memory) {
    const std::lock_guard lock(mutex_);
    const auto place = std::find_if(free_.begin(), free_.end(), [&](const HostMemory& one) {
        return one.bytes() >= memory.bytes();
    });
    free_.insert(place, std::move(memory));  // the smallest first, as take() wants them
    std::uint64_t held = 0;
    for (const HostMemory& one : free_) held += one.bytes();
    for (; held > kMostBytes; free_.erase(free_.begin())) held -= free_.front().bytes();
}

HostMemory Queue::host_memory(std::uint64_t bytes) {
    const auto size = static_cast<std::size_t>(bytes);
    std::shared_ptr<std::byte[]> memory = std::make_unique_for_overwrite<std::byte[]>(size);
    const std::span<std::byte> all(memory.get(), size);
    return {std::move(memory), all};
}

std::size_t Queue::number_of(std::string_view kernel) {
    auto& kernels = work_.kernels;
    const auto known = std::find_if(kernels.begin(), kernels.end(),
                                    [&](const KernelWork& one) { return one.name == kernel; });
    if (known != kernels.end()) return static_cast<std::size_t>(known - kernels.begin());
    kernels.push_back({std::string(kernel)});
    return kernels.size() - 1;
}

void Queue::launch(const KernelShape& kernel, std::span<std::byte> arguments,
                   std::span<const Buffer> buffers, std::uint64_t items, std::uint64_t work) {
    const std::uint64_t group = group_size();
    const std::uint64_t side_by_side = device().kind == "cpu" ? 1 : kItemsSideBySide;
    const std::uint64_t groups = std::clamp<std::uint64_t>(
        kWorkPerSlice * side_by_side / group / std::max<std::uint64_t>(work, 1), 1, most_groups());
    const std::size_t number = number_of(kernel.name);
    for (std::uint64_t first = 0; first < items; first += groups * group) {
        if (queued_ >= kWorkPerPause * side_by_side) {
            ask();
            pause();
            queued_ = 0;
        }
        const auto first_item = static_cast<std::uint32_t>(first);
        std::memcpy(arguments.data(), &first_item, sizeof(first_item));
        const std::uint64_t served = std::min(groups * group, items - first);
        enqueue(kernel, arguments, buffers,
                static_cast<std::uint32_t>((served + group - 1) / group), number);
        queued_ += served * work;
        ++work_.launches;
        ++work_.kernels[number].launches;
        work_.kernels[number].items += served;
    }
}

void Queue::upload(const Buffer& to, std::span<const std::byte> from, std::uint64_t offset) {
    if (from.empty()) return;
    ++work_.uploads;
    work_.uploaded_bytes += from.size();
    enqueue_upload(to, from, offset);
}

void Queue::download(const Buffer& from, std::span<std::byte> to) {
    if (to.empty()) return;
    ++work_.downloads;
    work_.downloaded_bytes += to.size();
    enqueue_download(from, to);
}

void Queue::wait() {
    ask();
    ++work_.waits;
    finish();
    queued_ = 0;
}

DeviceError ended_early(const DeviceEntry& device, const std::string& job) {
    return DeviceError("device " + device.name + ": " + job +
                       ": a loop was ended early by the driver, which grants fewer turns than "
                       "this set takes: use another backend");
}

}  // namespace lacuna::device
