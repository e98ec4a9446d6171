// Prefix sums on a device: where what was counted goes.
#pragma once

#include <cstdint>

#include "backends/device/round_memory.h"

namespace lacuna::device {

// Makes room for so many counts, and their sums.
void make_room_to_scan(RoundMemory& round, std::uint64_t count);

// Queues this: each of so many `counts` becomes the sum of those before it in its block, `sums` of
// each block the sum of all blocks before it, and `total` that of all.
void scan(RoundMemory& round, std::uint32_t count);
// A block has 2^block_bits_of_scan() counts: about as many as there are blocks, two short sums in
// place of a long one. Lavapipe takes each item's division one by one, but shifts eight at a time.
std::uint32_t block_bits_of_scan(std::uint64_t count);

}  // namespace lacuna::device
