// What the opencl backend keeps on the device, and the queue that all work goes through.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "device/layout.h"
#include "opencl/cl.h"
#include "opencl/program.h"

namespace lacuna::opencl {

// Admission passes queued at a time; one that finds nothing undecided returns at once. Most rounds
// settle in five or six.
inline constexpr std::uint32_t kPasses = 8;

struct Kernels {
    explicit Kernels(const cl::Program& program);
    cl::Kernel locate, sort_columns, admit, gather, subtract, grow;
};

// An in-order queue: each command sees what those before it have done.
class Queue {
public:
    Queue(const Program& program, std::uint64_t* launches);

    // Runs the kernel for at least so many work items, more to fill the last group.
    template <typename... Arguments>
    void launch(cl::Kernel& kernel, std::uint32_t items, const Arguments&... arguments) {
        if (items == 0) return;
        cl_uint index = 0;
        (kernel.setArg(index++, arguments), ...);
        launch_all(kernel, items);
    }

    // How many draws a work item serves: a few long chunks a core on a processor, 1 elsewhere.
    std::uint32_t chunk_of(std::uint32_t draws) const;

    template <typename T>
    void write(const cl::Buffer& to, std::span<const T> from) {
        if (!from.empty())
            queue_.enqueueWriteBuffer(to, CL_TRUE, 0, from.size_bytes(), from.data());
    }
    // `to` is filled when finish() returns.
    template <typename T>
    void start_read(const cl::Buffer& from, std::span<T> to) {
        if (!to.empty()) queue_.enqueueReadBuffer(from, CL_FALSE, 0, to.size_bytes(), to.data());
    }
    // Zeroes one word a pass, or the first.
    void zero(const cl::Buffer& buffer, std::size_t words);
    void finish() { queue_.finish(); }

private:
    void launch_all(const cl::Kernel& kernel, std::uint32_t items);

    cl::CommandQueue queue_;
    std::uint64_t* launches_;
    std::uint32_t group_size_;
    std::uint32_t chunks_;  // 0: as many as there are draws
};

// See kernels/ for what each buffer holds.
struct State {
    State(std::shared_ptr<Program> program, const Plan& plan, const device::Tuning& tuning,
          std::uint64_t* launches);

    std::shared_ptr<Program> program;
    Queue queue;
    Kernels kernels;
    const Plan& plan;
    portable::Geometry geometry;
    std::uint64_t largest_slab_bytes;

    std::vector<device::Slab> slabs;
    std::vector<cl::Buffer> spans;  // of each slab
    cl::Buffer span_counts, free_lengths;

    std::uint32_t draw_count = 0;  // of the round
    std::uint32_t draw_room = 0;   // of the buffers, which grow with the largest round
    cl::Buffer draws, located, candidates, fates, samples, near;
    cl::Buffer column_begins, near_begins, near_counts;
    cl::Buffer undecided, overflow;

    std::vector<std::uint32_t> host_column_begins, host_near_begins;

    // Shares the lines out over new slabs with room for so many spans a line; nothing in them yet.
    void allocate_slabs(std::uint32_t capacity);
    // Room for so many spans a line, with those it has.
    void grow(std::uint32_t larger);
    // Takes the round's tables from host_column_begins, and makes room for its draws.
    void begin_round(std::uint32_t draws);

    Snapshot snapshot();
    void restore(const Snapshot& snapshot);

private:
    cl::Buffer buffer(std::uint64_t bytes) const;
};

}  // namespace lacuna::opencl
