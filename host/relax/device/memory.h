// What relaxation keeps on a device: sites, the tree over them, and the leaves of the lattice.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "backends/device/kernels.h"
#include "backends/device/queue.h"
#include "portable/site_tree.h"
#include "relax/lattice.h"

namespace lacuna::relaxing::device {

using lacuna::device::Memory;
using lacuna::device::Queue;

// Tiles with importance, by their numbers row by row, and of each a bit for each leaf of it that
// has importance.
struct Tiles {
    std::vector<std::uint32_t> numbers;
    std::vector<std::uint32_t> leaves;
};
Tiles tiles_of(const Lattice& lattice);

// How many tiles, or leaves, lie side by side in so many lattice points.
constexpr std::uint32_t tiles_in(std::uint32_t points) {
    return (points - 1) / (TILE_SIDE * LEAF_SIDE) + 1;
}
constexpr std::uint32_t leaves_in(std::uint32_t points) {
    return (points - 1) / LEAF_SIDE + 1;
}

// Of the tree over so many sites: its root's level, at least 1, and where a level is stored.
std::uint32_t depth_of(std::size_t sites);
std::uint32_t begin_of_level(std::uint32_t depth, std::uint32_t level);

// Buffers for so many sites and tiles, in batches of so many units, and the lattice's masses.
// Throws Unavailable where the device is too small.
Memory make_memory(Queue& queue, const Lattice& lattice, std::size_t sites, std::size_t tiles,
                   std::size_t units_of_batch);

}  // namespace lacuna::relaxing::device
