// The memory of relaxation on a device: sites, the tree over them, and the leaves of the lattice.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "backends/device/kernels.h"
#include "backends/device/queue.h"
#include "lattice/lattice.h"
#include "portable/site_tree.h"

namespace lacuna::relaxing::device {

using lacuna::device::Memory;
using lacuna::device::Queue;

// The tiles with importance: their numbers, row by row, and for each a bit for each leaf with
// importance.
struct Tiles {
    std::vector<std::uint32_t> numbers;
    std::vector<std::uint32_t> leaves;
};
Tiles tiles_of(const Lattice& lattice);

// Number of tiles, or leaves, along `points` lattice points.
constexpr std::uint32_t tiles_in(std::uint32_t points) {
    return (points - 1) / (TILE_SIDE * LEAF_SIDE) + 1;
}
// The level of the root of a tree over `sites` sites, at least 1; the index where a level begins.
std::uint32_t depth_of(std::size_t sites);
std::uint32_t begin_of_level(std::uint32_t depth, std::uint32_t level);

// A buffer, and its size.
struct Need {
    lacuna::device::Buffer Memory::*buffer;
    std::uint64_t words;
};
// Allocates buffers. Throws Unavailable if the device is too small.
Memory make_buffers(Queue& queue, std::span<const Need> needs);

// Allocates buffers for the lattice's masses, the sites, the tiles, and batches of units_of_batch
// units. Throws Unavailable if the device is too small.
Memory make_memory(Queue& queue, const Lattice& lattice, std::size_t sites, std::size_t tiles,
                   std::size_t units_of_batch);

}  // namespace lacuna::relaxing::device
