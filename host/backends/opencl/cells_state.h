// What the opencl backend keeps on the device in mode cells.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "backends/backend.h"
#include "backends/opencl/cl.h"
#include "backends/opencl/program.h"
#include "backends/opencl/round_memory.h"
#include "plan/plan.h"

namespace lacuna::opencl {

struct CellsKernels {
    explicit CellsKernels(const cl::Program& program);
    cl::Kernel locate_in_cells, sort_columns, look_up_radii, admit_in_cells, subtract_in_cells;
};

// See kernels/ for what each buffer holds.
struct CellsState : RoundMemory {
    CellsState(std::shared_ptr<Program> program, const Plan& plan, std::uint64_t* launches);

    CellsKernels kernels;
    std::uint32_t words;   // of a line's bits
    std::uint32_t rows;    // of pixels
    std::uint32_t metric;  // portable/metric.h

    // The radius map, as the plan has it.
    cl::Buffer pixel_radii, pixel_reaches, widest_rows, column_of, row_of, row_begins;
    cl::Buffer bits, widest;  // of every line
    cl::Buffer candidate_radii;

    // Finds the radius of each candidate.
    void queue_radii();

    Snapshot snapshot();
    void restore(const Snapshot& snapshot);

private:
    cl::Buffer copy_of(std::span<const std::uint32_t> values);
    void write_first_bits();

    std::uint32_t candidate_room_ = 0;
};

}  // namespace lacuna::opencl
