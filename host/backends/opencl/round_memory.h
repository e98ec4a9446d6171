// What every mode keeps on the device of a round: its draws, their candidates, what becomes of
// them, and whether the work was finished.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "backends/backend.h"
#include "backends/opencl/cl.h"
#include "backends/opencl/program.h"
#include "backends/opencl/queue.h"
#include "plan/plan.h"
#include "portable/geometry.h"

namespace lacuna::opencl {

// See kernels/ for what each buffer holds. The queue may use the host's vectors until it is
// drained.
struct RoundMemory {
    RoundMemory(std::shared_ptr<Program> program, const Plan& plan, std::uint64_t* launches);

    std::shared_ptr<Program> program;
    Queue queue;
    const Plan& plan;
    portable::Geometry geometry;

    // The places that draws fall on: lines, then boxes.
    std::uint32_t place_count;
    cl::Buffer free_lengths;
    std::vector<std::uint32_t> host_place_begins;  // of each column; columns + 1
    std::uint32_t place_width() const { return plan.strip_width; }

    std::uint32_t draw_count = 0;  // of the round
    cl::Buffer draws, located, buckets, candidates, fates, pending, samples;
    cl::Buffer column_begins, undecided, failure;
    std::vector<std::uint32_t> host_column_begins;

    // After read_flags.
    bool is_unsettled() const { return host_undecided_.back() != 0; }

    // The draws and their table; makes room for what becomes of them.
    void upload(std::span<const Draw> draws);
    // What was located, sorted by column and y.
    void sort(cl::Kernel& sort_columns);
    // Passes from 1 on take up what earlier ones left undecided.
    void begin_passes(std::uint32_t first_pass);
    // Waits for what is queued. Throws DeviceError when a kernel could not finish its work.
    void read_flags();
    // Sets the first words to 0.
    void zero(const cl::Buffer& of, std::uint32_t count);

    void snapshot_round(Snapshot& snapshot);
    void restore_round(const Snapshot& snapshot);

protected:
    cl::Buffer on_device(std::uint64_t bytes) const;
    cl::Buffer words_on_device(std::uint64_t count) const;

private:
    void begin_round(std::uint32_t count);
    void make_room(std::uint32_t count);

    std::uint32_t draw_room_ = 0;  // of the buffers, which grow with the largest round
    std::array<std::uint32_t, kPasses> host_undecided_{};
    std::array<std::uint32_t, 1> host_failure_{};
};

}  // namespace lacuna::opencl
