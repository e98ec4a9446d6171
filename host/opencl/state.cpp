// The opencl backend's memory.
#include "opencl/state.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "columns.h"
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
    : program(std::move(the_program)),
      queue(*program, launches),
      kernels(program->program),
      plan(the_plan),
      geometry(device::geometry_of(plan, count_columns(plan), 0)),
      largest_slab_bytes(tuning.largest_slab_bytes != 0 ? tuning.largest_slab_bytes
                                                        : program->entry.largest_buffer_bytes),
      place_count(plan.lines),
      length_room(std::max(plan.lines, kLeastRoom)),
      host_place_begins(first_lines(plan, geometry.columns)) {
    const std::uint64_t columns = geometry.columns;
    span_counts = words(plan.lines);
    free_lengths = words(length_room);
    place_begins = words(columns + 1);
    column_begins = words(columns + 1);
    near_begins = words(columns + 1);
    near_counts = words(columns);
    undecided = words(kPasses);
    overflow = words(1);
    failure = words(1);
    total = words(1);
    zero(undecided, kPasses);
    zero(overflow, 1);
    zero(failure, 1);
    if (plan.exact) make_cells();
    make_lines();
}

void State::make_cells() {
    const std::uint64_t cells = std::uint64_t{plan.cell_columns} * plan.cell_rows;
    cell_x = words(cells);
    cell_y = words(cells);
    queue.fill(cell_x, cells, NO_SAMPLE);
    queue.fill(cell_y, cells, NO_SAMPLE);
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

cl::Buffer State::buffer(std::uint64_t bytes) const {
    return {program->context, CL_MEM_READ_WRITE, std::max<std::size_t>(bytes, sizeof(cl_uint4))};
}

cl::Buffer State::words(std::uint64_t count) const {
    return buffer(count * sizeof(cl_uint));
}

void State::zero(const cl::Buffer& of, std::uint32_t count) {
    static constexpr std::array<std::uint32_t, kPasses> kZeros{};
    queue.start_write(of, std::span(kZeros).first(count));
}

void State::allocate_slabs(std::uint32_t capacity) {
    geometry.capacity = capacity;
    slabs = device::share_out(plan.lines, capacity, largest_slab_bytes);
    spans.clear();
    for (const device::Slab& slab : slabs)
        spans.push_back(buffer(std::uint64_t{slab.lines()} * capacity * sizeof(Span)));
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

void State::begin_round(std::uint32_t count) {
    device::find_near_begins(plan, geometry.columns, host_column_begins, host_near_begins);
    draw_count = count;
    if (draw_room < count || draw_room == 0) {
        draw_room = count;
        draws = buffer(std::uint64_t{count} * sizeof(Draw));
        located = buffer(std::uint64_t{count} * sizeof(Candidate));
        buckets = words(count);
        candidates = buffer(std::uint64_t{count} * sizeof(Candidate));
        fates = words(count);
        pending = words(count);
        samples = buffer(std::uint64_t{count} * sizeof(Sample));
        // Each lies near its own column and those on either side.
        near = buffer(std::uint64_t{count} * 3 * sizeof(Sample));
    }
    queue.start_write<std::uint32_t>(column_begins, host_column_begins);
    queue.start_write<std::uint32_t>(near_begins, host_near_begins);
    zero(undecided, kPasses);
    zero(overflow, 1);
    zero(failure, 1);
}

void State::make_room(Boxes& of, std::uint32_t count) const {
    if (of.room >= count && of.room != 0) return;
    const std::uint32_t room = std::max(count, kLeastRoom);
    of = {};  // first let go of what was there
    of = {words(room), words(room), words(room), room};
}

void State::make_room_for_strips(std::uint32_t count) {
    if (strip_room >= count && strip_room != 0) return;
    counts = piece_begin = piece_end = sums = {};
    strip_room = std::max(count, kLeastRoom);
    counts = words(std::uint64_t{strip_room} + 1);
    piece_begin = words(strip_room);
    piece_end = words(strip_room);
    sums = words(std::uint64_t{strip_room} / queue.block_of(0) + 1);
}

void State::make_room_for_lengths(std::uint32_t count) {
    if (length_room >= count) return;
    free_lengths = {};
    length_room = count;
    free_lengths = words(count);
}

void State::read_flags() {
    queue.start_read<std::uint32_t>(undecided, host_undecided);
    queue.start_read<std::uint32_t>(overflow, host_overflow);
    queue.start_read<std::uint32_t>(failure, host_failure);
    queue.finish();
    if (host_failure.front() != 0) throw kernel_error(host_failure.front(), program->entry.name);
}

Snapshot State::snapshot() {
    Snapshot snapshot;
    snapshot.capacity = geometry.capacity;
    snapshot.candidates.resize(draw_count);
    snapshot.fates.resize(draw_count);
    snapshot.box_width = box_width;
    const std::size_t cells =
        plan.exact ? std::size_t{plan.cell_columns} * plan.cell_rows : std::size_t{0};
    std::vector<std::uint32_t> span_count(plan.lines), x(cells), y(cells);
    std::vector<std::uint32_t> box_x(has_boxes() ? place_count : 0);
    std::vector<std::uint32_t> box_begin(box_x.size()), box_end(box_x.size());
    queue.start_read(candidates, std::span(snapshot.candidates));
    queue.start_read(fates, std::span(snapshot.fates));
    queue.start_read(span_counts, std::span(span_count));
    queue.start_read(cell_x, std::span(x));
    queue.start_read(cell_y, std::span(y));
    queue.start_read(boxes.x, std::span(box_x));
    queue.start_read(boxes.begin, std::span(box_begin));
    queue.start_read(boxes.end, std::span(box_end));
    queue.drain();
    for (std::size_t i = 0; i < cells; ++i) snapshot.cells.push_back({x[i], y[i]});
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
    if (plan.exact) {
        std::vector<std::uint32_t> x, y;
        for (const Sample sample : snapshot.cells) {
            x.push_back(sample.x);
            y.push_back(sample.y);
        }
        queue.write<std::uint32_t>(cell_x, x);
        queue.write<std::uint32_t>(cell_y, y);
    }

    find_column_begins(plan, geometry.columns, std::span(snapshot.candidates), host_column_begins);
    begin_round(static_cast<std::uint32_t>(snapshot.candidates.size()));
    queue.write<Candidate>(candidates, snapshot.candidates);
    queue.write<std::uint32_t>(fates, snapshot.fates);
    queue.write<std::uint32_t>(pending,
                               device::pending_of(snapshot.fates, queue.chunk_of(draw_count)));
    queue.write<Sample>(samples, device::samples_by_order(snapshot));
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
