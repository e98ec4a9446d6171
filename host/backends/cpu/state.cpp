// The cpu backend's memory.
#include "backends/cpu/state.h"

#include <algorithm>

#include "backends/columns.h"
#include "portable/column.h"

namespace lacuna::cpu {

State::State(const Plan& the_plan)
    : plan(the_plan),
      columns(count_columns(plan)),
      first_lines(lacuna::first_lines(plan, columns)),
      capacity(first_capacity(plan)),
      spans(std::make_unique_for_overwrite<Span[]>(std::size_t{plan.lines} * capacity)),
      span_counts(plan.lines, 1),
      boxes(plan.is_exact() ? columns : 0),
      place_begins(first_lines),
      free_lengths(plan.lines, plan.height),
      column_begins(columns + std::size_t{1}) {
    for (std::uint32_t line = 0; line < plan.lines; ++line) slot(line)[0] = {0, plan.height};
    if (plan.is_exact()) grid.emplace(plan);
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

Snapshot State::snapshot() const {
    Snapshot snapshot;
    snapshot.capacity = capacity;
    for (std::uint32_t line = 0; line < plan.lines && !has_boxes(); ++line) {
        const std::span<Span> of_line = slot(line).first(span_counts[line]);
        snapshot.spans.emplace_back(of_line.begin(), of_line.end());
    }
    snapshot.candidates = candidates;
    snapshot.fates = fates;
    for (std::uint32_t i = 0; i < plan.grid_columns && grid; ++i)
        snapshot.grid.insert(snapshot.grid.end(), grid->column(i),
                             grid->column(i) + plan.grid_rows);
    snapshot.box_width = box_width;
    for (const std::vector<Box>& of_column : boxes)
        snapshot.boxes.insert(snapshot.boxes.end(), of_column.begin(), of_column.end());
    return snapshot;
}

void State::restore(const Snapshot& snapshot) {
    capacity = snapshot.capacity;
    box_width = snapshot.box_width;
    if (has_boxes())
        restore_boxes(snapshot);
    else
        restore_spans(snapshot);
    for (std::uint32_t i = 0; i < plan.grid_columns && grid; ++i)
        std::copy_n(snapshot.grid.data() + std::size_t{i} * plan.grid_rows, plan.grid_rows,
                    grid->column(i));
    candidates = snapshot.candidates;
    fates = snapshot.fates;
    find_column_begins(plan, columns, candidates, column_begins);
}

void State::restore_spans(const Snapshot& snapshot) {
    spans = std::make_unique_for_overwrite<Span[]>(std::size_t{plan.lines} * capacity);
    place_begins = first_lines;
    free_lengths.assign(plan.lines, 0);
    for (std::uint32_t line = 0; line < plan.lines; ++line) {
        const std::vector<Span>& from = snapshot.spans[line];
        std::copy(from.begin(), from.end(), slot(line).begin());
        span_counts[line] = static_cast<std::uint32_t>(from.size());
        for (const Span span : from) free_lengths[line] += span.end - span.begin;
    }
}

void State::restore_boxes(const Snapshot& snapshot) {
    boxes.assign(columns, {});
    free_lengths.clear();
    for (const Box box : snapshot.boxes) {
        boxes[portable::column_of_line(box.x / plan.strip_width, plan.lines, columns)].push_back(
            box);
        free_lengths.push_back(box.end - box.begin);
    }
    for (std::uint32_t column = 0; column < columns; ++column)
        place_begins[column + 1] =
            place_begins[column] + static_cast<std::uint32_t>(boxes[column].size());
}

}  // namespace lacuna::cpu
