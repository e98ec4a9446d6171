// The opencl backend's memory in lines and exact.
#include "backends/opencl/state.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "backends/columns.h"
#include "portable/column.h"
#include "portable/fate.h"

namespace lacuna::opencl {
namespace {

// Of boxes, and of strips; small sets do without more.
constexpr std::uint32_t kLeastRoom = 4096;

}  // namespace

Kernels::Kernels(const cl::Program& program)
    : locate(program, "locate"),
      locate_in_boxes(program, "locate_in_boxes"),
      sort_columns(program, "sort_columns"),
      screen(program, "screen"),
      admit(program, "admit"),
      gather(program, "gather"),
      subtract(program, "subtract"),
      grow(program, "grow"),
      insert(program, "insert"),
      unfold(program, "unfold"),
      cut(program, "cut"),
      scan(program, "scan"),
      keep(program, "keep"),
      find_place_begins(program, "find_place_begins") {}

State::State(std::shared_ptr<Program> the_program, const Plan& the_plan,
             const device::Tuning& tuning, std::uint64_t* launches)
    : RoundMemory(std::move(the_program), the_plan, launches),
      kernels(program->program),
      largest_slab_bytes(tuning.largest_slab_bytes != 0 ? tuning.largest_slab_bytes
                                                        : program->entry.largest_buffer_bytes),
      length_room(std::max(plan.lines, kLeastRoom)) {
    const std::uint64_t columns = geometry.columns;
    span_counts = words_on_device(plan.lines);
    free_lengths = words_on_device(length_room);
    place_begins = words_on_device(columns + 1);
    near_begins = words_on_device(columns + 1);
    near_counts = words_on_device(columns);
    overflow = words_on_device(1);
    total = words_on_device(1);
    zero(overflow, 1);
    if (plan.is_exact()) make_cells();
    make_lines();
}

void State::make_cells() {
    const std::uint64_t cells = std::uint64_t{plan.grid_columns} * plan.grid_rows;
    grid_x = words_on_device(cells);
    grid_y = words_on_device(cells);
    queue.fill(grid_x, cells, NO_SAMPLE);
    queue.fill(grid_y, cells, NO_SAMPLE);
}

// Of one span each, written in a row, then spread out.
void State::make_lines() {
    allocate_slabs(1);
    for (std::size_t i = 0; i < slabs.size(); ++i)
        queue.write<Span>(spans[i], std::vector<Span>(slabs[i].lines(), Span{0, plan.height}));
    queue.write<std::uint32_t>(span_counts, std::vector<std::uint32_t>(plan.lines, 1));
    queue.write<std::uint32_t>(free_lengths, std::vector<std::uint32_t>(plan.lines, plan.height));
    grow(first_capacity(plan));
    queue.drain();  // lets go of the rows before other buffers are made
}

void State::allocate_slabs(std::uint32_t capacity) {
    geometry.capacity = capacity;
    slabs = device::share_out(plan.lines, capacity, largest_slab_bytes);
    spans.clear();
    for (const device::Slab& slab : slabs)
        spans.push_back(on_device(std::uint64_t{slab.lines()} * capacity * sizeof(Span)));
}

void State::grow(std::uint32_t larger) {
    const portable::Geometry old = geometry;
    const std::vector<device::Slab> old_slabs = std::move(slabs);
    const std::vector<cl::Buffer> old_spans = std::move(spans);
    allocate_slabs(larger);
    for (std::size_t from = 0; from < old_slabs.size(); ++from) {
        for (std::size_t to = 0; to < slabs.size(); ++to) {
            const auto begin = std::max(old_slabs[from].first_line, slabs[to].first_line);
            const auto end = std::min(old_slabs[from].end_line, slabs[to].end_line);
            if (begin < end)
                queue.launch(kernels.grow, end - begin, old, old_slabs[from].first_line,
                             slabs[to].first_line, begin, end, geometry.capacity, span_counts,
                             old_spans[from], spans[to]);
        }
    }
}

// Expects the round begun.
void State::begin_near() {
    device::find_near_begins(plan, geometry.columns, host_column_begins, host_near_begins_);
    if (near_room_ < draw_count || near_room_ == 0) {
        near_room_ = draw_count;
        // Each lies near its own column and those on either side.
        near = on_device(std::uint64_t{draw_count} * 3 * sizeof(Sample));
    }
    queue.start_write<std::uint32_t>(near_begins, host_near_begins_);
    zero(overflow, 1);
}

void State::upload(std::span<const Draw> the_draws) {
    RoundMemory::upload(the_draws);
    begin_near();
}

void State::make_room(Boxes& of, std::uint32_t count) const {
    if (of.room >= count && of.room != 0) return;
    const std::uint32_t room = std::max(count, kLeastRoom);
    of = {};  // first let go of what was there
    of = {words_on_device(room), words_on_device(room), words_on_device(room), room};
}

void State::make_room_for_strips(std::uint32_t count) {
    if (strip_room >= count && strip_room != 0) return;
    counts = piece_begin = piece_end = sums = {};
    strip_room = std::max(count, kLeastRoom);
    counts = words_on_device(std::uint64_t{strip_room} + 1);
    piece_begin = words_on_device(strip_room);
    piece_end = words_on_device(strip_room);
    sums = words_on_device(std::uint64_t{strip_room} / queue.block_of(0) + 1);
}

void State::make_room_for_lengths(std::uint32_t count) {
    if (length_room >= count) return;
    free_lengths = {};
    length_room = count;
    free_lengths = words_on_device(count);
}

void State::read_flags() {
    queue.start_read<std::uint32_t>(overflow, host_overflow);
    RoundMemory::read_flags();
}

Snapshot State::snapshot() {
    Snapshot snapshot;
    snapshot_round(snapshot);
    snapshot.box_width = box_width;
    const std::size_t cells =
        plan.is_exact() ? std::size_t{plan.grid_columns} * plan.grid_rows : std::size_t{0};
    std::vector<std::uint32_t> span_count(plan.lines), x(cells), y(cells);
    std::vector<std::uint32_t> box_x(has_boxes() ? place_count : 0);
    std::vector<std::uint32_t> box_begin(box_x.size()), box_end(box_x.size());
    queue.start_read(span_counts, std::span(span_count));
    queue.start_read(grid_x, std::span(x));
    queue.start_read(grid_y, std::span(y));
    queue.start_read(boxes.x, std::span(box_x));
    queue.start_read(boxes.begin, std::span(box_begin));
    queue.start_read(boxes.end, std::span(box_end));
    queue.drain();
    for (std::size_t i = 0; i < cells; ++i) snapshot.grid.push_back({x[i], y[i]});
    for (std::size_t i = 0; i < box_x.size(); ++i)
        snapshot.boxes.push_back({box_x[i], box_begin[i], box_end[i]});
    for (std::size_t i = 0; i < slabs.size() && !has_boxes(); ++i) {
        std::vector<Span> slots(std::size_t{slabs[i].lines()} * geometry.capacity);
        queue.start_read(spans[i], std::span(slots));
        queue.drain();
        device::unpack(slabs[i], slots, span_count, snapshot);
    }
    return snapshot;
}

void State::restore(const Snapshot& snapshot) {
    geometry.capacity = snapshot.capacity;
    box_width = snapshot.box_width;
    if (has_boxes())
        restore_boxes(snapshot);
    else
        restore_spans(snapshot);
    if (plan.is_exact()) {
        std::vector<std::uint32_t> x, y;
        for (const Sample sample : snapshot.grid) {
            x.push_back(sample.x);
            y.push_back(sample.y);
        }
        queue.write<std::uint32_t>(grid_x, x);
        queue.write<std::uint32_t>(grid_y, y);
    }
    restore_round(snapshot);
    begin_near();
}

void State::restore_spans(const Snapshot& snapshot) {
    allocate_slabs(snapshot.capacity);
    for (std::size_t i = 0; i < slabs.size(); ++i)
        queue.write<Span>(spans[i], device::pack(slabs[i], snapshot));
    std::vector<std::uint32_t> span_count, lengths;
    for (const std::vector<Span>& of_line : snapshot.spans) {
        span_count.push_back(static_cast<std::uint32_t>(of_line.size()));
        lengths.push_back(0);
        for (const Span span : of_line) lengths.back() += span.end - span.begin;
    }
    queue.write<std::uint32_t>(span_counts, span_count);
    queue.write<std::uint32_t>(free_lengths, lengths);
    place_count = plan.lines;
    host_place_begins = first_lines(plan, geometry.columns);
}

void State::restore_boxes(const Snapshot& snapshot) {
    place_count = static_cast<std::uint32_t>(snapshot.boxes.size());
    host_place_begins.assign(geometry.columns + std::size_t{1}, 0);
    std::vector<std::uint32_t> x, begin, end, lengths;
    for (const Box& box : snapshot.boxes) {
        x.push_back(box.x);
        begin.push_back(box.begin);
        end.push_back(box.end);
        lengths.push_back(box.end - box.begin);
        ++host_place_begins[portable::column_of_line(box.x / plan.strip_width, plan.lines,
                                                     geometry.columns) +
                            1];
    }
    for (std::uint32_t column = 0; column < geometry.columns; ++column)
        host_place_begins[column + 1] += host_place_begins[column];
    make_room(boxes, place_count);
    make_room_for_lengths(place_count);
    queue.write<std::uint32_t>(boxes.x, x);
    queue.write<std::uint32_t>(boxes.begin, begin);
    queue.write<std::uint32_t>(boxes.end, end);
    queue.write<std::uint32_t>(free_lengths, lengths);
}

}  // namespace lacuna::opencl
