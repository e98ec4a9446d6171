// Prefix sums: of the values within each block, then of the blocks' sums, then of the sums of
// these.
#include "backends/device/scan.h"

#include <algorithm>
#include <bit>

#include "backends/device/kernels.h"
#include "portable/report.h"

namespace lacuna::device {
namespace {

constexpr std::uint32_t kLeastBits = 6;  // 2^6: with less, launching takes longer than adding
constexpr std::uint64_t kScanWork = 1;   // of eight values, see Queue::launch

}  // namespace

std::uint32_t block_bits_of_scan(std::uint64_t count) {
    return std::max(kLeastBits, (static_cast<std::uint32_t>(std::bit_width(count)) + 2) / 3);
}

std::uint64_t blocks_of_scan(std::uint64_t count) {
    return (count >> block_bits_of_scan(count)) + 1;
}

void make_room_to_scan(RoundMemory& round, std::uint64_t count) {
    round.make_room(round.memory.counts, count);
    // Fewer counts may have up to twice as many blocks, which are half as long.
    round.make_room(round.memory.sums, 2 * blocks_of_scan(count));
    round.make_room(round.memory.tops, 2 * blocks_of_scan(count));
}

void scan(Queue& queue, const Memory& memory, std::uint32_t count) {
    const std::uint32_t block = std::uint32_t{1} << block_bits_of_scan(count);
    const auto launch_level = [&](const Buffer& values, const Buffer& sums, std::uint32_t amount,
                                  std::uint32_t to) {
        Memory level = memory;
        level.counts = values;
        level.sums = sums;
        launch<kernels::scan>(queue, level, {.count = amount, .block = block, .to = to},
                              std::max<std::uint64_t>(items_of(amount, block), 1),
                              block * kScanWork / 8);
    };
    const auto blocks = static_cast<std::uint32_t>(items_of(count, block));
    launch_level(memory.counts, memory.sums, count, 0);
    launch_level(memory.sums, memory.tops, blocks, 0);
    launch_level(memory.tops, memory.report, static_cast<std::uint32_t>(items_of(blocks, block)),
                 TOTAL_WORD);
}

}  // namespace lacuna::device
