// Prefix sums on a device: they turn counts into the indices at which kernels write.
#pragma once

#include <cstdint>

#include "backends/device/round_memory.h"

namespace lacuna::device {

// Makes room for `count` counts, and their sums.
void make_room_to_scan(RoundMemory& round, std::uint64_t count);

// Queues the sums in three levels: then sum_before() of bodies/common/sums.h has the sum of the
// counts before each of `count` counts, and report[TOTAL_WORD] the sum of all.
void scan(Queue& queue, const Memory& memory, std::uint32_t count);
// A block has 2^block_bits_of_scan() counts, about the cube root of their number: three short sums
// replace a long one. A power of 2: lavapipe shifts for eight items at a time but divides for one.
std::uint32_t block_bits_of_scan(std::uint64_t count);
// The number of words that sums[] and tops[] need.
std::uint64_t blocks_of_scan(std::uint64_t count);

}  // namespace lacuna::device
