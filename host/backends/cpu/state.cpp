// The cpu backend's memory.
#include "backends/cpu/state.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <utility>

#include "backends/columns.h"
#include "backends/cpu/reached.h"
#include "base/large_pages.h"
#include "plan/first_free.h"
#include "portable/column.h"
#include "portable/metric.h"
#include "portable/status.h"

namespace lacuna::cpu {

State::State(const Plan& the_plan)
    : plan(the_plan),
      columns(count_columns(plan)),
      first_lines(lacuna::first_lines(plan, columns)),
      bin_width(plan.strip_width),
      bin_begins(first_lines),
      free_lengths(first_free_lengths(plan)),
      column_begins(columns + std::size_t{1}) {}

State::State(const Plan& the_plan, std::vector<std::uint32_t> region_begins)
    : plan(the_plan),
      columns(static_cast<std::uint32_t>(region_begins.size()) - 1),
      bin_width(plan.strip_width),
      bin_begins(std::move(region_begins)),
      column_begins(columns + std::size_t{1}) {
    FirstFree first(plan);
    free_lengths = std::move(first.lengths);
    bin_widths = std::move(first.widths);
    sheet_ends = std::move(first.sheet_ends);
}

void State::make_room(std::size_t count) {
    candidates.resize(count);
    statuses.resize(count);
    if (!plan.is_exact()) buckets.resize(count);
}

void State::find_orders(std::uint32_t column) {
    for (std::uint32_t i = column_begins[column]; i < column_begins[column + 1]; ++i)
        by_order[candidates[i].order] = i;
}

void State::begin_round(std::span<const Draw> draws) {
    make_room(draws.size());
    by_order.resize(draws.size());
    find_column_begins(bin_begins, draws, column_begins);
}

Snapshot State::snapshot(Stage stage) const {
    Snapshot snapshot;
    snapshot.candidates = candidates;
    snapshot.statuses = statuses;
    // What screen found is not shown.
    if (stage == Stage::located)
        std::fill(snapshot.statuses.begin(), snapshot.statuses.end(), STATUS_UNDECIDED);
    return snapshot;
}

void State::restore(const Snapshot& snapshot) {
    candidates = snapshot.candidates;
    statuses = snapshot.statuses;
    make_room(candidates.size());
    by_order.resize(candidates.size());
    find_column_begins(plan, columns, candidates, column_begins);
    for (std::uint32_t column = 0; column < columns; ++column) {
        if (!plan.is_exact()) sort_column(column);
        find_orders(column);
    }
}

SpanState::SpanState(const Plan& the_plan)
    : State(the_plan),
      capacity(first_capacity(plan)),
      spans(std::make_unique_for_overwrite<Span[]>(std::size_t{plan.lines} * capacity)),
      span_counts(plan.lines),
      boxes(plan.is_exact() ? columns : 0) {
    ask_for_large_pages(spans.get(), std::size_t{plan.lines} * capacity);
    if (plan.is_exact()) grid.emplace(plan);
}

void SpanState::set_spans(std::uint32_t line, std::span<const Span> of_line) {
    std::copy(of_line.begin(), of_line.end(), slot(line).begin());
    span_counts[line] = static_cast<std::uint32_t>(of_line.size());
}

void SpanState::grow() {
    const std::unique_ptr<Span[]> old = std::move(spans);
    const std::uint32_t old_capacity = std::exchange(capacity, 2 * capacity);
    spans = std::make_unique_for_overwrite<Span[]>(std::size_t{plan.lines} * capacity);
    ask_for_large_pages(spans.get(), std::size_t{plan.lines} * capacity);
    for (std::uint32_t line = 0; line < plan.lines; ++line)
        set_spans(line, {old.get() + std::size_t{line} * old_capacity, span_counts[line]});
}

void SpanState::settle_boxes(std::uint32_t width) {
    has_boxes = true;
    bin_width = width;
    spans.reset();
    span_counts = {};
    free_lengths.clear();
    for (std::uint32_t column = 0; column < columns; ++column) {
        for (const Box box : boxes[column]) free_lengths.push_back(box.end - box.begin);
        bin_begins[column + 1] = static_cast<std::uint32_t>(free_lengths.size());
    }
}

// Snapshots have candidates sorted by y, which exact does not keep.
void SpanState::sort_columns(Snapshot& snapshot) const {
    std::vector<std::uint32_t> sorted(candidates.size());
    std::iota(sorted.begin(), sorted.end(), 0u);
    for (std::uint32_t column = 0; column < columns; ++column)
        std::sort(sorted.begin() + column_begins[column],
                  sorted.begin() + column_begins[column + 1],
                  [&](std::uint32_t a, std::uint32_t b) {
                      return comes_before(candidates[a], candidates[b]);
                  });
    const std::vector<std::uint32_t> unsorted = snapshot.statuses;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        snapshot.candidates[i] = candidates[sorted[i]];
        snapshot.statuses[i] = unsorted[sorted[i]];
    }
}

Snapshot SpanState::snapshot(Stage stage) const {
    Snapshot snapshot = State::snapshot(stage);
    snapshot.capacity = capacity;
    for (std::uint32_t line = 0; line < plan.lines && !has_boxes; ++line) {
        const std::span<Span> of_line = slot(line).first(span_counts[line]);
        snapshot.spans.emplace_back(of_line.begin(), of_line.end());
    }
    for (std::uint32_t i = 0; i < plan.grid().columns && grid; ++i)
        snapshot.grid.insert(snapshot.grid.end(), grid->column(i),
                             grid->column(i) + plan.grid().rows);
    // In a snapshot the round's samples enter the grid with the round's last verb, not with admit.
    for (std::size_t i = 0; grid && stage == Stage::admitted && i < candidates.size(); ++i)
        if (statuses[i] == STATUS_ADMITTED)
            snapshot.grid[std::size_t{candidates[i].x / plan.grid().side} * plan.grid().rows +
                          candidates[i].y / plan.grid().side] = {NO_SAMPLE, NO_SAMPLE};
    if (grid) sort_columns(snapshot);
    snapshot.box_width = has_boxes ? bin_width : 0;
    for (const std::vector<Box>& of_column : boxes)
        snapshot.boxes.insert(snapshot.boxes.end(), of_column.begin(), of_column.end());
    return snapshot;
}

void SpanState::restore(const Snapshot& snapshot) {
    State::restore(snapshot);
    if (grid) grid->clear(0, 1);  // the margin, too, which is in no snapshot
    for (std::uint32_t i = 0; i < plan.grid().columns && grid; ++i)
        std::copy_n(snapshot.grid.data() + std::size_t{i} * plan.grid().rows, plan.grid().rows,
                    grid->column(i));
    if (snapshot.box_width != 0) {
        boxes.assign(columns, {});
        for (const Box box : snapshot.boxes)
            boxes[portable::column_of_line(box.x / plan.strip_width, plan.lines, columns)]
                .push_back(box);
        settle_boxes(snapshot.box_width);
        return;
    }
    has_boxes = false;
    bin_width = plan.strip_width;
    bin_begins = first_lines;
    capacity = snapshot.capacity;
    spans = std::make_unique_for_overwrite<Span[]>(std::size_t{plan.lines} * capacity);
    span_counts.resize(plan.lines);
    free_lengths.assign(plan.lines, 0);
    for (std::uint32_t line = 0; line < plan.lines; ++line) {
        set_spans(line, snapshot.spans[line]);
        for (const Span span : snapshot.spans[line]) free_lengths[line] += span.end - span.begin;
    }
}

BitState::BitState(const Plan& the_plan)
    : State(the_plan),
      radii(*plan.cells().radii),
      words(words_per_line(plan) / 2),
      bits(std::make_unique_for_overwrite<std::uint64_t[]>(plan.lines * words)),
      widest(plan.lines),
      near_begins(columns + std::size_t{1}) {
    widest_candidates.of_columns.resize(columns);
    // With min the radii of free points are not tracked: a limit that none of them exceeds.
    widest_open.of_columns.resize(columns,
                                  plan.cells().metric == Metric::min ? ~std::uint32_t{0} : 0);
    widest_open.find_blocks();
}

void BitState::make_room(std::size_t count) {
    State::make_room(count);
    candidate_radii.resize(count);
}

void BitState::begin_round(std::span<const Draw> draws) {
    State::begin_round(draws);
    candidate_radii.resize(draws.size());
}

void BitState::set_bits(std::uint32_t index, std::span<const std::uint32_t> of_line) {
    for (std::size_t i = 0; i < words; ++i)
        line(index)[i] = std::uint64_t{of_line[2 * i + 1]} << 32 | of_line[2 * i];
}

void BitState::find_radii(std::uint32_t column) {
    std::uint32_t widest_radius = 0;
    for (std::uint32_t i = column_begins[column]; i < column_begins[column + 1]; ++i) {
        candidate_radii[i] = radii.radii[radii.pixel_at(candidates[i].x, candidates[i].y)];
        widest_radius = std::max(widest_radius, candidate_radii[i]);
    }
    widest_candidates.of_columns[column] = widest_radius;
}

void WidestRadii::find_blocks() {
    of_blocks.assign(of_columns.size() / kBlock + 1, 0);
    for (std::size_t column = 0; column < of_columns.size(); ++column)
        of_blocks[column / kBlock] = std::max(of_blocks[column / kBlock], of_columns[column]);
}

void BitState::find_widest_open() {
    if (plan.cells().metric == Metric::min) return;
    for (std::uint32_t column = 0; column < columns; ++column) {
        std::uint32_t widest_radius = 0;
        for (std::uint32_t x = first_lines[column]; x < first_lines[column + 1]; ++x) {
            if (widest[x] == radii.rows) continue;
            const std::size_t pixels = std::size_t{radii.column_of[x]} * radii.rows;
            widest_radius = std::max(
                widest_radius,
                portable::class_bound(radii.radii[pixels + radii.widest_rows[pixels + widest[x]]]));
        }
        widest_open.of_columns[column] = widest_radius;
    }
    widest_open.find_blocks();
}

void BitState::find_near(const std::function<void()>& poll) {
    // Counts the candidates of each column first, then lists them.
    find_widest_open();
    const auto for_each_near = [&](auto visit) {
        for (std::uint32_t i = 0; i < candidates.size(); ++i) {
            if (i % 1024 == 0) poll();
            if (statuses[i] != STATUS_ADMITTED) continue;
            Reach(*this, candidates[i], candidate_radii[i], widest_open)
                .any([&](std::uint32_t column, std::uint32_t) { return visit(column, i), false; });
        }
    };
    std::fill(near_begins.begin(), near_begins.end(), 0);
    for_each_near([&](std::uint32_t column, std::uint32_t) { ++near_begins[column]; });
    std::uint32_t sum = 0;
    for (std::uint32_t& begin : near_begins) begin = sum += begin;
    near.resize(sum);
    for_each_near([&](std::uint32_t column, std::uint32_t i) { near[--near_begins[column]] = i; });
}

Snapshot BitState::snapshot(Stage stage) const {
    Snapshot snapshot = State::snapshot(stage);
    for (std::size_t i = 0; i < plan.lines * words; ++i) {
        snapshot.bits.push_back(static_cast<std::uint32_t>(bits[i]));
        snapshot.bits.push_back(static_cast<std::uint32_t>(bits[i] >> 32));
    }
    return snapshot;
}

void BitState::restore(const Snapshot& snapshot) {
    State::restore(snapshot);
    const std::span<const std::uint32_t> all = snapshot.bits;
    for (std::uint32_t i = 0; i < plan.lines; ++i) {
        set_bits(i, all.subspan(2 * words * i, 2 * words));
        free_lengths[i] = 0;
        for (const std::uint64_t word : line(i))
            free_lengths[i] += static_cast<std::uint32_t>(std::popcount(word));
    }
    std::fill(widest.begin(), widest.end(), 0);
    candidate_radii.resize(candidates.size());
    for (std::uint32_t column = 0; column < columns; ++column) find_radii(column);
    end_locate();
}

void set_free(SpanState& state, std::uint32_t column) {
    for (std::uint32_t i = state.first_lines[column]; i < state.first_lines[column + 1]; ++i)
        state.set_spans(i, first_spans(state.plan, i));
    if (state.grid) state.grid->clear(column, state.columns);
}

void set_free(BitState& state, std::uint32_t column) {
    const std::uint32_t begin = state.first_lines[column];
    const std::uint32_t end = state.first_lines[column + 1];
    const std::vector<std::uint32_t> bits = first_bits(state.plan, begin, end);
    for (std::uint32_t i = begin; i < end; ++i)
        state.set_bits(i, std::span(bits).subspan(2 * state.words * (i - begin), 2 * state.words));
}

}  // namespace lacuna::cpu
