// How large the buffers are, and whether the device has room for them.
#include "relax/device/memory.h"

#include <lacuna/lacuna.h>

#include <algorithm>
#include <cstddef>

#include "backends/device/layout.h"
#include "portable/site_tree.h"

namespace lacuna::relaxing::device {
namespace {

using lacuna::device::Buffer;
using lacuna::device::kWord;

// A rival's id has 4 bits beside the number of its site.
constexpr std::size_t kMostSites = std::size_t{1} << 28;

struct Need {
    Buffer Memory::*buffer;
    std::uint64_t words;
};

std::vector<Need> needs_of(const Lattice& lattice, std::uint64_t sites, std::uint64_t leaves,
                           std::uint64_t batch) {
    const std::uint32_t depth = depth_of(sites);
    const std::uint64_t nodes =
        begin_of_level(depth, 1) +
        std::uint64_t{portable::nodes_of_level(static_cast<std::uint32_t>(sites), 1)};
    const std::uint64_t rows = batch * LEAF_SIDE;
    const std::uint64_t rivals = batch * RIVAL_ROOM;
    return {{&Memory::sites, 4 * sites},
            {&Memory::node_boxes, 4 * nodes},
            {&Memory::node_lifts, 2 * nodes},
            {&Memory::least, 2},
            {&Memory::leaves, leaves},
            {&Memory::indices, sites},
            {&Memory::hints, leaves},
            {&Memory::rivals, 4 * rivals},
            {&Memory::rival_ids, 2 * rivals},
            {&Memory::ranked, rivals},
            {&Memory::rival_counts, batch},
            {&Memory::masses, (lattice.mass.size() + 1) / 2},
            {&Memory::row_masses, 4 * rows},
            {&Memory::winners, 2 * rows},
            {&Memory::shares, 4 * sites},
            {&Memory::moments, 4 * sites},
            {&Memory::failure, 1},
            {&Memory::owners, 1}};
}

void refuse_if_too_large(const DeviceEntry& device, const std::vector<Need>& needs,
                         std::size_t sites) {
    if (sites > kMostSites)
        throw Unavailable("device " + device.name + ": at most 2^28 points can be relaxed on it");
    lacuna::device::Needs all;
    for (const Need& need : needs) {
        all.bytes += need.words * kWord;
        all.largest = std::max(all.largest, need.words * kWord);
    }
    lacuna::device::refuse_if_too_large(device.name, all, device.memory_bytes,
                                        device.largest_buffer_bytes);
}

}  // namespace

std::vector<std::uint32_t> leaves_of(const Lattice& lattice) {
    const portable::RelaxLattice& numbers = lattice.numbers;
    const std::uint32_t columns = (numbers.columns - 1) / LEAF_SIDE + 1;
    const std::uint32_t rows = (numbers.rows - 1) / LEAF_SIDE + 1;
    std::vector<std::uint32_t> leaves;
    std::vector<bool> has_importance(columns);
    for (std::uint32_t row = 0; row < rows; ++row) {
        std::fill(has_importance.begin(), has_importance.end(), false);
        const std::uint32_t top = std::min(numbers.rows, (row + 1) * LEAF_SIDE) - 1;
        for (std::uint32_t y = row * LEAF_SIDE / numbers.cut_y; y <= top / numbers.cut_y; ++y)
            for (std::uint32_t x = 0; x < numbers.pixel_columns; ++x) {
                if (lattice.mass[std::size_t{y} * numbers.pixel_columns + x] == 0) continue;
                const std::uint32_t end = ((x + 1) * numbers.cut_x - 1) / LEAF_SIDE;
                for (std::uint32_t leaf = x * numbers.cut_x / LEAF_SIDE; leaf <= end; ++leaf)
                    has_importance[leaf] = true;
            }
        for (std::uint32_t column = 0; column < columns; ++column)
            if (has_importance[column]) leaves.push_back(row * columns + column);
    }
    return leaves;
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

Memory make_memory(Queue& queue, const Lattice& lattice, std::size_t sites, std::size_t leaves,
                   std::size_t leaves_of_batch) {
    const std::vector<Need> needs =
        needs_of(lattice, sites, leaves, std::min(leaves, leaves_of_batch));
    refuse_if_too_large(queue.device(), needs, sites);
    Memory memory;
    for (const Need& need : needs) memory.*need.buffer = queue.make(need.words * kWord);
    return memory;
}

}  // namespace lacuna::relaxing::device
