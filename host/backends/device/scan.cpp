// Prefix sums: first of the values within each block, then of the blocks' sums.
#include "backends/device/scan.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "backends/device/kernels.h"

namespace lacuna::device {
namespace {

constexpr std::uint32_t kSmallestBlock = 256;
constexpr std::uint64_t kScanWork = 1;  // of eight values, see Queue::launch

}  // namespace

std::uint32_t block_bits_of_scan(std::uint64_t count) {
    const auto root = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(count)));
    return static_cast<std::uint32_t>(std::bit_width(std::max(kSmallestBlock, root) - 1));
}

void make_room_to_scan(RoundMemory& round, std::uint64_t count) {
    round.make_room(round.memory.counts, count);
    round.make_room(round.memory.sums, count / kSmallestBlock + 1);
    round.make_room(round.memory.total, 1);
}

void scan(Queue& queue, const Memory& memory, std::uint32_t count) {
    const std::uint32_t block = std::uint32_t{1} << block_bits_of_scan(count);
    const auto blocks = static_cast<std::uint32_t>(items_of(count, block));
    queue.fill(memory.total, 0, 1);
    launch<kernels::scan>(queue, memory, {.count = count, .block = block}, blocks,
                          block * kScanWork / 8);
    Memory of_blocks = memory;
    of_blocks.counts = memory.sums;
    of_blocks.sums = memory.total;
    launch<kernels::scan>(queue, of_blocks, {.count = blocks, .block = blocks},
                          std::min(blocks, 1u), blocks * kScanWork / 8);
}

}  // namespace lacuna::device
