// The parts of a round whose draws crowd, see cpu/crowd.h: each is admitted after the samples of
// those before it were taken out of the places. No call of a device in here.
//
// On a device parts do one thing more: they bound the loops of a work item, since lavapipe allows
// an item so many turns and no more (portable/failure.h).
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace lacuna::device {

// Draws of one column that a part has at most: a work item sorts them, and a candidate is compared
// with those of three columns.
inline constexpr std::uint32_t kMostOfColumn = 512;

// Draws that a part has at most, and the first one; each later one as many as all before it.
struct PartLimits {
    std::uint32_t first = std::numeric_limits<std::uint32_t>::max();
    std::uint32_t most = std::numeric_limits<std::uint32_t>::max();
    std::uint32_t of_column = kMostOfColumn;
};

// Of a round of so many draws, where radii differ: within a candidate's own radius lies such a
// share of the domain, on average and at most. The first part is so small that a candidate has few
// others there, where those of wide radii lie beside those of small ones. All are so small that one
// of the widest reach, which may look at all others, takes no more turns than there are.
PartLimits limits_by_area(std::uint32_t count, double mean_disk_area, double widest_disk_area);

// Where the parts end, by the order of the draws, whose columns are given in that order.
std::vector<std::uint32_t> find_part_ends(std::span<const std::uint32_t> column_of_order,
                                          std::uint32_t columns, PartLimits limits);

// Whether one part has room for all.
bool is_one_part(std::span<const std::uint32_t> column_begins, PartLimits limits);

// Draws or candidates that come column by column: which come where, part by part and column by
// column within a part.
struct Arrangement {
    std::vector<std::uint32_t> ends;     // of the parts
    std::vector<std::uint32_t> origins;  // of each entry, among those given; empty with one part
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

    // A part's entries are as many as its orders.
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
