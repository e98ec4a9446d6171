// What relaxation keeps on a device: sites, the tree over them, and the leaves of the lattice.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "backends/device/kernels.h"
#include "backends/device/queue.h"
#include "relax/lattice.h"

namespace lacuna::relaxing::device {

using lacuna::device::Memory;
using lacuna::device::Queue;

// Leaves with importance, by their numbers row by row.
std::vector<std::uint32_t> leaves_of(const Lattice& lattice);

// Of the tree over so many sites: its root's level, at least 1, and where a level is stored.
std::uint32_t depth_of(std::size_t sites);
std::uint32_t begin_of_level(std::uint32_t depth, std::uint32_t level);

// Buffers for so many sites and leaves, in batches of so many leaves, and the lattice's masses on
// their way up. Throws Unavailable where the device is too small.
Memory make_memory(Queue& queue, const Lattice& lattice, std::size_t sites, std::size_t leaves,
                   std::size_t leaves_of_batch);

}  // namespace lacuna::relaxing::device
