// Prefix sums on a device: they turn counts into the indices at which kernels write.
#pragma once

#include <cstdint>

#include "backends/device/round_memory.h"

namespace lacuna::device {

// Makes room for `count` counts, and their sums.
void make_room_to_scan(RoundMemory& round, std::uint64_t count);

// Queues the sums: each of `count` counts becomes the sum of the earlier ones in its block,
// sums[block] the sum of all earlier blocks, and `total` the sum of all counts.
void scan(Queue& queue, const Memory& memory, std::uint32_t count);
// A block has 2^block_bits_of_scan() counts, about as many as there are blocks: two short sums
// replace a long one. A power of 2: lavapipe shifts for eight items at a time but divides for one.
std::uint32_t block_bits_of_scan(std::uint64_t count);

}  // namespace lacuna::device
