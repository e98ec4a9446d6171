// The parts of a round whose draws crowd.
#include "backends/device/parts.h"

#include "backends/columns.h"
#include "backends/device/queue.h"

namespace lacuna::device {

PartLimits limits_by_area(std::uint32_t count, double mean_disk_area, double widest_disk_area) {
    PartLimits limits;
    const double most = std::max<double>(kFewDraws, kMostTurns / widest_disk_area);
    if (count > most) limits.most = static_cast<std::uint32_t>(most);
    if (count > kFewDraws && count * mean_disk_area > kMostRivals)
        limits.first = static_cast<std::uint32_t>(std::max(kMostRivals / mean_disk_area, 64.0));
    return limits;
}

bool is_one_part(std::span<const std::uint32_t> column_begins, PartLimits limits) {
    if (column_begins.back() > std::min(limits.first, limits.most)) return false;
    for (std::size_t column = 1; column < column_begins.size(); ++column)
        if (column_begins[column] - column_begins[column - 1] > limits.of_column) return false;
    return true;
}

std::vector<std::uint32_t> find_part_ends(std::span<const std::uint32_t> column_of_order,
                                          std::uint32_t columns, PartLimits limits) {
    const auto count = static_cast<std::uint32_t>(column_of_order.size());
    std::vector<std::uint32_t> ends;
    std::vector<std::uint32_t> of_column(columns, 0);
    std::uint32_t begin = 0;
    std::uint32_t room = std::min(limits.first, limits.most);
    for (std::uint32_t order = 0; order < count; ++order) {
        if (order - begin == room || of_column[column_of_order[order]] == limits.of_column) {
            ends.push_back(begin = order);
            room = std::min(std::max(order, limits.first), limits.most);
            std::fill(of_column.begin(), of_column.end(), 0);
        }
        ++of_column[column_of_order[order]];
    }
    ends.push_back(count);
    return ends;
}

}  // namespace lacuna::device
