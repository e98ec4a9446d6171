// What the vulkan backend keeps on the device in mode cells: the lattice's bits, the radius map,
// and what belongs to a round.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "backends/backend.h"
#include "backends/vulkan/engine.h"
#include "backends/vulkan/round_memory.h"

namespace lacuna::vulkan {

struct CellsState : RoundMemory {
    // Every lattice point that has importance is free.
    CellsState(const Plan& plan, Engine& engine);

    // As RoundMemory's, and the cells' part. `upload` ends with a barrier. Recorded.
    void upload(std::span<const Draw> draws);
    void download();

    Snapshot snapshot();
    // The candidates, to be sorted; and then what became of them.
    void begin_restored(const Snapshot& snapshot);

    std::vector<std::uint32_t> first_lines;  // of each column; columns + 1

    // Bit y of a line, in word y / 32 of its `words`, is set while its lattice point is free.
    std::uint32_t words;
    Buffer bits, free_lengths, widest;

    // See radius_map.h.
    Buffer pixel_radii, pixel_reaches, widest_rows, column_of, row_of, row_begins;

    // Of the round: of each candidate, and which of them subtract has yet to serve.
    Buffer candidate_radii, todo, left, left_count;
    Buffer free_lengths_down, left_count_down;

private:
    void set_bits();
    void make_candidate_room();

    std::uint32_t candidate_room_ = 0;
};

}  // namespace lacuna::vulkan
