// The lines, bins and draws of each column.
#include "backends/columns.h"

#include <algorithm>

#include "plan/sizes.h"
#include "portable/column.h"

namespace lacuna {
namespace {

// begins[column] becomes the index of the first entry that is not below the column.
template <typename Entry, typename IsBelow>
void find_begins(std::uint32_t columns, std::span<const Entry> entries,
                 std::vector<std::uint32_t>& begins, IsBelow is_below) {
    begins.resize(columns + std::size_t{1});
    auto begin = entries.begin();
    for (std::uint32_t column = 0; column <= columns; ++column) {
        begin = std::partition_point(begin, entries.end(),
                                     [&](const Entry& entry) { return is_below(entry, column); });
        begins[column] = static_cast<std::uint32_t>(begin - entries.begin());
    }
}

}  // namespace

std::uint32_t count_columns(const Plan& plan) {
    // However the lines are divided, a column then has at least radius / strip_width lines. The sum
    // takes 33 bits if both the radius and the only strip are as wide as the domain.
    const std::uint64_t widest = std::uint64_t{plan.radius} + plan.strip_width;
    return std::max(1u, static_cast<std::uint32_t>(plan.width / widest));
}

std::vector<std::uint32_t> first_lines(const Plan& plan, std::uint32_t columns) {
    std::vector<std::uint32_t> lines;
    for (std::uint32_t column = 0; column <= columns; ++column)
        lines.push_back(portable::first_line_of_column(column, plan.lines, columns));
    return lines;
}

void find_column_begins(std::span<const std::uint32_t> bin_begins, std::span<const Draw> draws,
                        std::vector<std::uint32_t>& begins) {
    const auto columns = static_cast<std::uint32_t>(bin_begins.size() - 1);
    find_begins(columns, draws, begins, [&](const Draw& draw, std::uint32_t column) {
        return draw.bin < bin_begins[column];
    });
}

void find_column_begins(const Plan& plan, std::uint32_t columns,
                        std::span<const Candidate> candidates, std::vector<std::uint32_t>& begins) {
    find_begins(columns, candidates, begins, [&](const Candidate& candidate, std::uint32_t column) {
        return portable::column_of_line(candidate.home, plan.lines, columns) < column;
    });
}

std::uint32_t first_capacity(const Plan& plan) {
    const auto spans =
        static_cast<std::uint64_t>(most_spans(static_cast<double>(plan.height) / plan.radius));
    // Each sample adds at most one span to a line.
    return static_cast<std::uint32_t>(std::min(spans, std::min(spans, plan.limit) + 8));
}

}  // namespace lacuna
