// The queue that all of the opencl backend's work goes through.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <utility>

#include "backends/opencl/cl.h"
#include "backends/opencl/program.h"

namespace lacuna::opencl {

// Admission passes queued at a time; one that finds nothing undecided returns at once. Most rounds
// settle in five or six.
inline constexpr std::uint32_t kPasses = 8;

// An in-order queue: each command sees what those before it have done.
class Queue {
public:
    Queue(const Program& program, std::uint64_t* launches);

    // Asked before each wait and between the slices of long launches; false cancels the run.
    void watch(std::function<bool()> may_go_on) { may_go_on_ = std::move(may_go_on); }

    // Runs the kernel for at least so many work items, more to fill the last group.
    template <typename... Arguments>
    void launch(cl::Kernel& kernel, std::uint32_t items, const Arguments&... arguments) {
        launch_in_slices(kernel, items, 0, arguments...);
    }
    // The same, sliced if it is so much work, in draws or what takes as long, that the run should
    // be cancelled in between: throws Cancelled.
    template <typename... Arguments>
    void launch_in_slices(cl::Kernel& kernel, std::uint32_t items, std::uint64_t work,
                          const Arguments&... arguments) {
        if (items == 0) return;
        cl_uint index = 0;
        (kernel.setArg(index++, arguments), ...);
        launch_all(kernel, items, work);
    }

    // Whether a work item serves many draws: on a processor.
    bool serves_chunks() const { return chunks_ != 0; }
    // How many draws, or boxes, a work item serves: long chunks on a processor, 1 elsewhere.
    std::uint32_t chunk_of(std::uint32_t amount) const;
    // How many values a work item sums: as many as there are items, or long chunks.
    std::uint32_t block_of(std::uint32_t amount) const;

    template <typename T>
    void write(const cl::Buffer& to, std::span<const T> from) {
        if (!from.empty())
            queue_.enqueueWriteBuffer(to, CL_TRUE, 0, from.size_bytes(), from.data());
    }
    // The same from word `first` of the buffer on.
    void write_words(const cl::Buffer& to, std::uint64_t first,
                     std::span<const std::uint32_t> from) {
        queue_.enqueueWriteBuffer(to, CL_TRUE, first * sizeof(cl_uint), from.size_bytes(),
                                  from.data());
    }
    // As write, without waiting: `from` must stay as it is until finish() returns.
    template <typename T>
    void start_write(const cl::Buffer& to, std::span<const T> from) {
        if (!from.empty())
            queue_.enqueueWriteBuffer(to, CL_FALSE, 0, from.size_bytes(), from.data());
    }
    // `to` is filled when finish() returns.
    template <typename T>
    void start_read(const cl::Buffer& from, std::span<T> to) {
        if (!to.empty()) queue_.enqueueReadBuffer(from, CL_FALSE, 0, to.size_bytes(), to.data());
    }
    // Sets so many words to `value`, and waits.
    void fill(const cl::Buffer& buffer, std::uint64_t words, std::uint32_t value);
    // Waits. Throws Cancelled.
    void finish();
    // Waits, whatever has become of the run.
    void drain() { queue_.finish(); }

private:
    void launch_all(const cl::Kernel& kernel, std::uint32_t items, std::uint64_t work);
    void ask() const;

    cl::CommandQueue queue_;
    std::uint64_t* launches_;
    std::function<bool()> may_go_on_;
    std::uint32_t group_size_;
    std::uint32_t chunks_;  // 0: as many as there are draws
};

// How many items it takes to serve so many draws or boxes in chunks.
inline std::uint32_t items_of(std::uint32_t amount, std::uint32_t chunk) {
    return static_cast<std::uint32_t>((std::uint64_t{amount} + chunk - 1) / chunk);
}

}  // namespace lacuna::opencl
