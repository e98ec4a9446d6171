// What the opencl backend keeps on the device.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "device/layout.h"
#include "opencl/cl.h"
#include "opencl/program.h"
#include "opencl/queue.h"

namespace lacuna::opencl {

struct Kernels {
    explicit Kernels(const cl::Program& program);
    cl::Kernel locate, locate_in_boxes, sort_columns, screen, admit, gather, subtract, grow;
    cl::Kernel insert, unfold, cut, scan, keep, find_place_begins;
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

    // The lines' spans; let go of at the first refinement.
    std::vector<device::Slab> slabs;
    std::vector<cl::Buffer> spans;  // of each slab
    cl::Buffer span_counts;

    // In exact: the samples so far and, from the first refinement on, boxes.
    cl::Buffer cell_x, cell_y;
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

    // The places that draws fall on: lines, then boxes.
    std::uint32_t place_count;
    cl::Buffer free_lengths;
    std::uint32_t length_room;
    cl::Buffer place_begins;                       // of each column, where places are boxes
    std::vector<std::uint32_t> host_place_begins;  // columns + 1

    std::uint32_t draw_count = 0;  // of the round
    std::uint32_t draw_room = 0;   // of the buffers, which grow with the largest round
    cl::Buffer draws, located, buckets, candidates, fates, pending, samples, near;
    cl::Buffer column_begins, near_begins, near_counts;
    cl::Buffer undecided, overflow, failure;
    std::vector<std::uint32_t> host_column_begins, host_near_begins;
    // What read_flags found.
    std::array<std::uint32_t, kPasses> host_undecided{};
    std::array<std::uint32_t, 1> host_overflow{}, host_failure{}, host_total{};

    bool has_boxes() const { return box_width != 0; }
    std::uint32_t place_width() const { return has_boxes() ? box_width : plan.strip_width; }
    bool is_unsettled() const { return host_undecided.back() != 0; }

    // Shares the lines out over new slabs with room for so many spans a line; nothing in them yet.
    void allocate_slabs(std::uint32_t capacity);
    // Room for so many spans a line, with those it has.
    void grow(std::uint32_t larger);
    // Takes the round's tables from host_column_begins, and makes room for its draws.
    void begin_round(std::uint32_t draws);
    // Sets the first words to 0.
    void zero(const cl::Buffer& of, std::uint32_t count);
    // Room for so many boxes, or strips or lines to be counted; what was there is lost.
    void make_room(Boxes& boxes, std::uint32_t count) const;
    void make_room_for_strips(std::uint32_t count);
    void make_room_for_lengths(std::uint32_t count);

    // Waits for what is queued. Throws DeviceError when a kernel could not finish its work.
    void read_flags();

    Snapshot snapshot();
    void restore(const Snapshot& snapshot);

private:
    cl::Buffer buffer(std::uint64_t bytes) const;
    cl::Buffer words(std::uint64_t count) const;
    void make_cells();
    void make_lines();
    void restore_spans(const Snapshot& snapshot);
    void restore_boxes(const Snapshot& snapshot);
};

}  // namespace lacuna::opencl
