// The cpu backend's memory.
#include "cpu/state.h"

#include <algorithm>

#include "columns.h"
#include "portable/column.h"

namespace lacuna::cpu {
State::State(const Plan& the_plan)
    : plan(the_plan),
      columns(count_columns(plan)),
      capacity(first_capacity(plan)),
      spans(std::make_unique_for_overwrite<Span[]>(std::size_t{plan.lines} * capacity)),
      span_counts(plan.lines, 1),
      free_lengths(plan.lines, plan.height),
      column_begins(columns + std::size_t{1}) {
    for (std::uint32_t line = 0; line < plan.lines; ++line) slot(line)[0] = {0, plan.height};
}

std::uint32_t State::first_line(std::uint32_t column) const {
    return portable::first_line_of_column(column, plan.lines, columns);
}

void State::grow() {
    const std::uint32_t larger = 2 * capacity;
    auto moved = std::make_unique_for_overwrite<Span[]>(std::size_t{plan.lines} * larger);
    for (std::uint32_t line = 0; line < plan.lines; ++line) {
        const std::span<Span> old = slot(line).first(span_counts[line]);
        std::copy(old.begin(), old.end(), moved.get() + std::size_t{line} * larger);
    }
    spans = std::move(moved);
    capacity = larger;
}

void State::restore(const Snapshot& snapshot) {
    capacity = snapshot.capacity;
    spans = std::make_unique_for_overwrite<Span[]>(std::size_t{plan.lines} * capacity);
    for (std::uint32_t line = 0; line < plan.lines; ++line) {
        const std::vector<Span>& from = snapshot.spans[line];
        std::copy(from.begin(), from.end(), slot(line).begin());
        span_counts[line] = static_cast<std::uint32_t>(from.size());
        free_lengths[line] = 0;
        for (const Span span : from) free_lengths[line] += span.end - span.begin;
    }
    candidates = snapshot.candidates;
    fates = snapshot.fates;
    find_column_begins(plan, columns, candidates, column_begins);
}

}  // namespace lacuna::cpu
