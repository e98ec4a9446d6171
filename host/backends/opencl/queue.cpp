// The opencl backend's queue.
#include "backends/opencl/queue.h"

#include <lacuna/lacuna.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace lacuna::opencl {
namespace {

constexpr std::uint32_t kProcessorChunks = 32;  // a core: short ones, to share out evenly
constexpr std::uint32_t kLongestChunk = 8192;   // a few milliseconds
constexpr std::uint32_t kGraphicsGroup = 64;
constexpr std::uint32_t kSmallestBlock = 256;

// Draws that two cores serve in some 15 ms; with two slices on their way, a run is cancelled in a
// fraction of 0.2 s.
constexpr std::uint64_t kSlice = std::uint64_t{1} << 17;

constexpr std::size_t kFillWords = std::size_t{1} << 16;

}  // namespace

Queue::Queue(const Program& program, std::uint64_t* launches)
    : queue_(program.context, program.device), launches_(launches) {
    const bool processor = program.entry.kind == "cpu";
    const auto largest = program.device.getInfo<CL_DEVICE_MAX_WORK_GROUP_SIZE>();
    const auto units = program.device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>();
    // One size for all launches: PoCL compiles a kernel anew for each.
    group_size_ =
        processor ? 1 : static_cast<std::uint32_t>(std::min<std::size_t>(kGraphicsGroup, largest));
    chunks_ = processor ? units * kProcessorChunks : 0;
}

std::uint32_t Queue::chunk_of(std::uint32_t amount) const {
    return chunks_ == 0 ? 1 : std::clamp(amount / chunks_, 1u, kLongestChunk);
}

std::uint32_t Queue::block_of(std::uint32_t amount) const {
    const auto root = static_cast<std::uint32_t>(std::sqrt(amount));
    return std::max(kSmallestBlock, chunks_ == 0 ? root : amount / chunks_);
}

void Queue::ask() const {
    if (may_go_on_ && !may_go_on_()) throw Cancelled();
}

void Queue::launch_all(const cl::Kernel& kernel, std::uint32_t items, std::uint64_t work) {
    // Slices are whole groups.
    const std::uint64_t slices = std::max<std::uint64_t>(work / kSlice, 1);
    const std::uint64_t groups_of_slice = items / slices / group_size_ + 1;
    const std::uint64_t slice = groups_of_slice * group_size_;
    cl::Event last;
    for (std::uint64_t first = 0; first < items; first += slice) {
        const std::uint64_t count = std::min<std::uint64_t>(slice, items - first);
        const std::uint64_t groups = (count + group_size_ - 1) / group_size_;
        cl::Event done;
        queue_.enqueueNDRangeKernel(kernel, cl::NDRange(first), cl::NDRange(groups * group_size_),
                                    cl::NDRange(group_size_), nullptr, &done);
        if (launches_ != nullptr) ++*launches_;
        if (slice >= items) return;
        queue_.flush();
        if (last() != nullptr) {
            ask();
            last.wait();  // one slice is left to work at
        }
        last = done;
    }
}

void Queue::fill(const cl::Buffer& buffer, std::uint64_t words, std::uint32_t value) {
    // Not clEnqueueFillBuffer: Oclgrind takes what it fills for uninitialized.
    const std::vector<std::uint32_t> some(std::min<std::uint64_t>(words, kFillWords), value);
    for (std::uint64_t at = 0; at < words; at += some.size()) {
        const std::uint64_t count = std::min<std::uint64_t>(some.size(), words - at);
        queue_.enqueueWriteBuffer(buffer, CL_FALSE, at * sizeof(cl_uint), count * sizeof(cl_uint),
                                  some.data());
    }
    queue_.finish();
}

void Queue::finish() {
    queue_.flush();
    ask();
    queue_.finish();
}

}  // namespace lacuna::opencl
