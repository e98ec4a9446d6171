// What the vulkan backend keeps on the device: the lines' free spans, and the round's candidates.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "backend.h"
#include "device/layout.h"
#include "vulkan/engine.h"
#include "vulkan/programs.h"

namespace lacuna::vulkan {

inline constexpr std::uint32_t kPasses = 8;  // of admit at a time; more are rarely needed

struct Memory {
    Memory(const Plan& plan, Engine& engine, const Kernel& grow, std::uint64_t largest_slab);

    // Twice the room for every line. Recorded.
    void grow();
    // The spans are no more needed.
    void drop_spans();

    // The draws and their tables on their way up, and what a round hands back on its way down: to
    // be found in the `_down` buffers after the wait. Recorded. place_begins: see columns.h.
    void upload(std::span<const Draw> draws, std::span<const std::uint32_t> place_begins);
    void download();

    // Draws of a column, on average and rounded up.
    std::uint32_t draws_per_column() const { return draw_count / geometry.columns + 1; }

    void snapshot_spans(Snapshot& snapshot);
    void snapshot_round(Snapshot& snapshot);
    void restore_spans(const Snapshot& snapshot);
    // The candidates, to be sorted; and then what became of them.
    void begin_restored_round(const Snapshot& snapshot);
    void restore_fates(const Snapshot& snapshot);

    const Plan& plan;
    Engine& engine;
    Kernel grow_kernel;
    std::uint64_t largest_slab;
    Geometry geometry;  // with the capacity of now

    // Free spans lie in slabs of whole lines: a storage buffer's range may be as small as 128 MiB,
    // and addresses in place of bindings would ask one feature more of the device.
    std::vector<device::Slab> slabs;
    std::vector<Buffer> spans;
    Buffer span_counts;
    Buffer free_lengths;

    // Of the round. `undecided` has a count for each pass.
    std::uint32_t draw_count = 0;
    Buffer draws, located, buckets, candidates, fates, samples, near;
    Buffer column_begins, near_begins, near_counts;
    Buffer undecided, overflow, failure;

    Buffer draws_up, column_begins_up, near_begins_up;
    Buffer samples_down, free_lengths_down, undecided_down, overflow_down, failure_down;

private:
    void make_slabs(std::uint32_t capacity);
    // Spans from slabs of g.capacity a line to the slabs of now. Recorded.
    void move_spans(const Geometry& g, std::span<const device::Slab> from_slabs,
                    std::span<const Buffer> from);
    void begin_round(std::uint32_t count);
    void make_room(std::uint32_t count);

    std::uint32_t draw_room_ = 0;
    std::uint32_t near_room_ = 0;
    std::vector<std::uint32_t> column_begins_;
    std::vector<std::uint32_t> near_begins_;
};

}  // namespace lacuna::vulkan
