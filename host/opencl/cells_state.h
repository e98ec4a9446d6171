// What the opencl backend keeps on the device in mode cells.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "backend.h"
#include "opencl/cl.h"
#include "opencl/program.h"
#include "opencl/queue.h"
#include "plan.h"
#include "portable/geometry.h"

namespace lacuna::opencl {

struct CellsKernels {
    explicit CellsKernels(const cl::Program& program);
    cl::Kernel locate_in_cells, sort_columns, look_up_radii, admit_in_cells, subtract_in_cells;
};

// See kernels/ for what each buffer holds.
struct CellsState {
    CellsState(std::shared_ptr<Program> program, const Plan& plan, std::uint64_t* launches);

    std::shared_ptr<Program> program;
    Queue queue;
    CellsKernels kernels;
    const Plan& plan;
    portable::Geometry geometry;
    std::uint32_t words;                     // of a line's bits
    std::uint32_t rows;                      // of pixels
    std::uint32_t metric;                    // portable/metric.h
    std::vector<std::uint32_t> first_lines;  // of each column; columns + 1

    // What read_flags found.
    std::array<std::uint32_t, kPasses> host_undecided{};
    std::array<std::uint32_t, 1> host_failure{};

    // The radius map, as the plan has it.
    cl::Buffer pixel_radii, pixel_reaches, column_of, row_of, row_begins;
    cl::Buffer bits, free_lengths;  // of every line

    std::uint32_t draw_count = 0;  // of the round
    std::uint32_t draw_room = 0;   // of the buffers, which grow with the largest round
    cl::Buffer draws, located, buckets, candidates, candidate_radii, fates, pending, samples;
    cl::Buffer column_begins, undecided, failure;
    std::vector<std::uint32_t> host_column_begins;

    bool is_unsettled() const { return host_undecided.back() != 0; }

    // Takes the round's table from host_column_begins, and makes room for its draws.
    void begin_round(std::uint32_t draws);
    // Finds the radius of each candidate.
    void queue_radii();
    // Waits for what is queued. Throws DeviceError when a kernel could not finish its work.
    void read_flags();

    Snapshot snapshot();
    void restore(const Snapshot& snapshot);

private:
    cl::Buffer buffer(std::uint64_t bytes) const;
    cl::Buffer words_of(std::uint64_t count) const;
    cl::Buffer copy_of(std::span<const std::uint32_t> values);
    void write_first_bits();
};

}  // namespace lacuna::opencl
