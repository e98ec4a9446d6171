// What the vulkan backend keeps on the device in lines and exact: the lines' free spans, and what
// belongs to a round.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "backends/backend.h"
#include "backends/device/layout.h"
#include "backends/vulkan/engine.h"
#include "backends/vulkan/round_memory.h"

namespace lacuna::vulkan {

struct Memory : RoundMemory {
    Memory(const Plan& plan, Engine& engine, const Kernel& grow, std::uint64_t largest_slab);

    // Twice the room for every line. Recorded.
    void grow();
    // The spans are no more needed.
    void drop_spans();

    // As RoundMemory's, and the spans' part. `upload` ends with a barrier.
    void upload(std::span<const Draw> draws, std::span<const std::uint32_t> place_begins);
    void download();

    void snapshot_spans(Snapshot& snapshot);
    void restore_spans(const Snapshot& snapshot);
    void begin_restored_round(const Snapshot& snapshot);

    Kernel grow_kernel;
    std::uint64_t largest_slab;

    // Free spans lie in slabs of whole lines: a storage buffer's range may be as small as 128 MiB,
    // and addresses in place of bindings would ask one feature more of the device.
    std::vector<device::Slab> slabs;
    std::vector<Buffer> spans;
    Buffer span_counts;
    Buffer free_lengths;

    Buffer near, near_begins, near_counts;
    Buffer overflow;

    Buffer near_begins_up;
    Buffer free_lengths_down, overflow_down;

private:
    void make_slabs(std::uint32_t capacity);
    // Spans from slabs of g.capacity a line to the slabs of now. Recorded.
    void move_spans(const Geometry& g, std::span<const device::Slab> from_slabs,
                    std::span<const Buffer> from);
    void begin_near();

    std::uint32_t near_room_ = 0;
    std::vector<std::uint32_t> near_begins_;
};

}  // namespace lacuna::vulkan
