// What the opencl backend keeps on the device in lines and exact.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "backends/device/layout.h"
#include "backends/opencl/cl.h"
#include "backends/opencl/program.h"
#include "backends/opencl/round_memory.h"

namespace lacuna::opencl {

struct Kernels {
    explicit Kernels(const cl::Program& program);
    cl::Kernel locate, locate_in_boxes, sort_columns, screen, admit, gather, subtract, grow;
    cl::Kernel insert, unfold, cut, scan, keep, find_place_begins;
};

// See kernels/ for what each buffer holds.
struct State : RoundMemory {
    State(std::shared_ptr<Program> program, const Plan& plan, const device::Tuning& tuning,
          std::uint64_t* launches);

    Kernels kernels;
    std::uint64_t largest_slab_bytes;

    // The lines' spans; let go of at the first refinement.
    std::vector<device::Slab> slabs;
    std::vector<cl::Buffer> spans;  // of each slab
    cl::Buffer span_counts;

    // In exact: the samples so far and, from the first refinement on, boxes.
    cl::Buffer grid_x, grid_y;
    struct Boxes {
        cl::Buffer x, begin, end;
        std::uint32_t room = 0;
    };
    Boxes boxes, new_boxes;
    std::uint32_t box_width = 0;  // 0 before
    // Of each strip that boxes are cut in, or line.
    cl::Buffer counts, piece_begin, piece_end;
    std::uint32_t strip_room = 0;
    cl::Buffer sums, total;  // of blocks of counts, and of all

    std::uint32_t length_room;  // of free_lengths
    cl::Buffer place_begins;    // of each column, where places are boxes

    cl::Buffer near, near_begins, near_counts, overflow;
    // What read_flags found.
    std::array<std::uint32_t, 1> host_overflow{}, host_total{};

    bool has_boxes() const { return box_width != 0; }
    std::uint32_t place_width() const {
        return has_boxes() ? box_width : RoundMemory::place_width();
    }

    // Shares the lines out over new slabs with room for so many spans a line; nothing in them yet.
    void allocate_slabs(std::uint32_t capacity);
    // Room for so many spans a line, with those it has.
    void grow(std::uint32_t larger);
    // Room for so many boxes, or strips or lines to be counted; what was there is lost.
    void make_room(Boxes& boxes, std::uint32_t count) const;
    void make_room_for_strips(std::uint32_t count);
    void make_room_for_lengths(std::uint32_t count);

    // As RoundMemory's, and the spans' part.
    void upload(std::span<const Draw> draws);
    void read_flags();

    Snapshot snapshot();
    void restore(const Snapshot& snapshot);

private:
    void make_cells();
    void make_lines();
    void begin_near();
    void restore_spans(const Snapshot& snapshot);
    void restore_boxes(const Snapshot& snapshot);

    std::uint32_t near_room_ = 0;
    std::vector<std::uint32_t> host_near_begins_;
};

}  // namespace lacuna::opencl
