// The parts of a round that crowds, see cpu/crowd.h: each part is admitted after the samples of the
// earlier ones were cut from the bins. No call of a device in here.
//
// On a device parts have one more purpose: they bound the loops of a work item, because lavapipe
// ends a loop after a fixed number of turns (portable/failure.h).
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace lacuna::device {

// In mode cells, the most draws of a column in one part: a work item sorts them, and a candidate is
// compared with the draws of three columns.
inline constexpr std::uint32_t kMostOfColumn = 512;

// The most draws of any part and of the first part; a later part has as many as all before it.
struct PartLimits {
    std::uint32_t first = std::numeric_limits<std::uint32_t>::max();
    std::uint32_t most = std::numeric_limits<std::uint32_t>::max();
    std::uint32_t of_column = std::numeric_limits<std::uint32_t>::max();
};

// The limits of a round of `count` draws. mean_disk_area and widest_disk_area
// are the average and the largest fraction of the domain that a candidate's disk covers. The first
// part is small enough that a candidate has few others within its radius. All parts are small
// enough that the candidate of the largest radius compares with at most kMostTurns others.
PartLimits limits_by_area(std::uint32_t count, double mean_disk_area, double widest_disk_area);

// Where the parts end, in draws by their order. The argument holds the column of each draw.
std::vector<std::uint32_t> find_part_ends(std::span<const std::uint32_t> column_of_order,
                                          std::uint32_t columns, PartLimits limits);

// Whether all draws fit into one part.
bool is_one_part(std::span<const std::uint32_t> column_begins, PartLimits limits);

// How draws or candidates, given column by column, are arranged part by part, and column by column
// within a part.
struct Arrangement {
    std::vector<std::uint32_t> ends;     // of the parts
    std::vector<std::uint32_t> origins;  // of each entry: index in `entries`; empty with one part
    std::vector<std::uint32_t> columns;  // of each entry; empty with one part
};

template <typename Entry>
Arrangement arrange(std::span<const Entry> entries, std::span<const std::uint32_t> column_begins,
                    PartLimits limits) {
    const auto count = static_cast<std::uint32_t>(entries.size());
    if (is_one_part(column_begins, limits)) return {{count}, {}, {}};
    const auto columns = static_cast<std::uint32_t>(column_begins.size() - 1);
    std::vector<std::uint32_t> of_order(count);
    for (std::uint32_t column = 0; column < columns; ++column)
        for (std::uint32_t i = column_begins[column]; i < column_begins[column + 1]; ++i)
            of_order[entries[i].order] = column;

    // A part has as many entries as orders.
    Arrangement made{find_part_ends(of_order, columns, limits), std::vector<std::uint32_t>(count),
                     std::vector<std::uint32_t>(count)};
    std::vector<std::uint32_t> next = made.ends;
    for (std::uint32_t i = count; i-- > 0;) {
        const std::uint32_t order = entries[i].order;
        const auto part = std::upper_bound(made.ends.begin(), made.ends.end(), order);
        const std::uint32_t to = --next[static_cast<std::size_t>(part - made.ends.begin())];
        made.origins[to] = i;
        made.columns[to] = of_order[order];
    }
    return made;
}

}  // namespace lacuna::device
