// Computes the sizes of the buffers, and checks that the device has room for them.
#include "relax/device/memory.h"

#include <lacuna/lacuna.h>

#include <algorithm>
#include <cstddef>

#include "backends/device/layout.h"
#include "portable/report.h"
#include "portable/site_tree.h"

namespace lacuna::relaxing::device {
namespace {

using lacuna::device::kWord;

// The id of a rival has 32 bits: 4 for the image, 28 for the number of its site.
constexpr std::size_t kMostSites = std::size_t{1} << 28;

std::vector<Need> needs_of(const Lattice& lattice, std::uint64_t sites, std::uint64_t tiles,
                           std::uint64_t batch) {
    const std::uint32_t depth = depth_of(sites);
    const std::uint64_t nodes =
        begin_of_level(depth, 1) +
        std::uint64_t{portable::nodes_of_level(static_cast<std::uint32_t>(sites), 1)};
    const std::uint64_t leaves =
        std::uint64_t{leaves_in(lattice.numbers.columns)} * leaves_in(lattice.numbers.rows);
    const std::uint64_t rivals = batch * RIVAL_ROOM;
    return {{&Memory::sites, 4 * sites},
            {&Memory::limited, 4 * sites},
            {&Memory::node_boxes, 4 * nodes},
            {&Memory::node_weights, 2 * nodes},
            {&Memory::units, tiles},
            {&Memory::tile_leaves, tiles},
            {&Memory::indices, sites},
            {&Memory::hints, leaves},
            {&Memory::rivals, 4 * rivals},
            {&Memory::rival_ids, rivals},
            {&Memory::rival_counts, batch},
            {&Memory::winners, batch * TILE_SIDE * TILE_SIDE * WINNER_ROOM},
            {&Memory::masses, lattice.masses.size()},
            {&Memory::exponents, leaves},
            {&Memory::shares, 4 * sites},
            {&Memory::moments, 4 * sites},
            {&Memory::late, leaves},
            {&Memory::late_count, 1},
            {&Memory::report, REPORT_WORDS},
            {&Memory::owners, 1}};
}

// Marks the leaves with importance in row `i` of a row of tiles.
void mark_leaves(const Lattice& lattice, std::uint32_t row, std::uint32_t i,
                 std::vector<std::uint32_t>& leaves) {
    const portable::RelaxLattice& numbers = lattice.numbers;
    const std::uint32_t bottom = (row * TILE_SIDE + i) * LEAF_SIDE;
    const std::uint32_t end = std::min(numbers.rows, bottom + LEAF_SIDE);
    if (bottom >= end) return;
    for (std::uint32_t y = bottom / numbers.cut_y; y <= (end - 1) / numbers.cut_y; ++y)
        for (std::uint32_t x = 0; x < numbers.pixel_columns; ++x) {
            if (lattice.masses[std::size_t{y} * numbers.pixel_columns + x] == 0) continue;
            const std::uint32_t last = ((x + 1) * numbers.cut_x - 1) / LEAF_SIDE;
            for (std::uint32_t leaf = x * numbers.cut_x / LEAF_SIDE; leaf <= last; ++leaf)
                leaves[leaf / TILE_SIDE] |= 1u << (i * TILE_SIDE + leaf % TILE_SIDE);
        }
}

}  // namespace

Tiles tiles_of(const Lattice& lattice) {
    const std::uint32_t columns = tiles_in(lattice.numbers.columns);
    Tiles tiles;
    std::vector<std::uint32_t> leaves(columns);
    for (std::uint32_t row = 0; row < tiles_in(lattice.numbers.rows); ++row) {
        std::fill(leaves.begin(), leaves.end(), 0);
        for (std::uint32_t i = 0; i < TILE_SIDE; ++i) mark_leaves(lattice, row, i, leaves);
        for (std::uint32_t column = 0; column < columns; ++column) {
            if (leaves[column] == 0) continue;
            tiles.numbers.push_back(row * columns + column);
            tiles.leaves.push_back(leaves[column]);
        }
    }
    return tiles;
}

std::uint32_t depth_of(std::size_t sites) {
    std::uint32_t depth = 1;
    while (sites > std::size_t{1} << (3 * depth)) ++depth;
    return depth;
}

std::uint32_t begin_of_level(std::uint32_t depth, std::uint32_t level) {
    std::uint32_t begin = 0;
    for (std::uint32_t at = depth; at > level; --at) begin = 8 * begin + 1;
    return begin;
}

Memory make_buffers(Queue& queue, std::span<const Need> needs) {
    const DeviceEntry& device = queue.device();
    lacuna::device::Needs all;
    for (const Need& need : needs) {
        all.bytes += need.words * kWord;
        all.largest = std::max(all.largest, need.words * kWord);
    }
    lacuna::device::refuse_if_too_large(device.name, all, device.memory_bytes,
                                        device.largest_buffer_bytes);
    Memory memory;
    for (const Need& need : needs) memory.*need.buffer = queue.make(need.words * kWord);
    return memory;
}

Memory make_memory(Queue& queue, const Lattice& lattice, std::size_t sites, std::size_t tiles,
                   std::size_t units_of_batch) {
    if (sites > kMostSites)
        throw Unavailable("device " + queue.device().name +
                          ": at most 2^28 points can be relaxed on it");
    return make_buffers(queue, needs_of(lattice, sites, tiles, units_of_batch));
}

}  // namespace lacuna::relaxing::device
