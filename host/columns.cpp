// The sharing out of lines and draws by column.
#include "columns.h"

#include <algorithm>

#include "portable/column.h"

namespace lacuna {

std::uint32_t count_columns(const Plan& plan) {
    // However rounding shares out the lines, a column then has radius / strip_width of them.
    return std::max(1u, plan.width / (plan.radius + plan.strip_width));
}

namespace {

template <typename Entry>
void find_begins(const Plan& plan, std::uint32_t columns, std::span<const Entry> entries,
                 std::vector<std::uint32_t>& begins) {
    begins.resize(columns + std::size_t{1});
    auto begin = entries.begin();
    for (std::uint32_t column = 0; column <= columns; ++column) {
        begin = std::partition_point(begin, entries.end(), [&](const Entry& entry) {
            return portable::column_of_line(entry.line, plan.lines, columns) < column;
        });
        begins[column] = static_cast<std::uint32_t>(begin - entries.begin());
    }
}

}  // namespace

void find_column_begins(const Plan& plan, std::uint32_t columns, std::span<const Draw> draws,
                        std::vector<std::uint32_t>& begins) {
    find_begins(plan, columns, draws, begins);
}

void find_column_begins(const Plan& plan, std::uint32_t columns,
                        std::span<const Candidate> candidates, std::vector<std::uint32_t>& begins) {
    find_begins(plan, columns, candidates, begins);
}

std::uint32_t first_capacity(const Plan& plan) {
    return plan.height / plan.radius / 2 + 8;
}

}  // namespace lacuna
