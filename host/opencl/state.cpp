// The opencl backend's memory and queue.
#include "opencl/state.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "columns.h"

namespace lacuna::opencl {
namespace {

constexpr std::uint32_t kProcessorChunks = 32;  // a core: short ones, to share out evenly
constexpr std::uint32_t kGraphicsGroup = 64;

}  // namespace

Kernels::Kernels(const cl::Program& program)
    : locate(program, "locate"),
      sort_columns(program, "sort_columns"),
      admit(program, "admit"),
      gather(program, "gather"),
      subtract(program, "subtract"),
      grow(program, "grow") {}

// ------------------------------------------------------------------------------------- the queue

Queue::Queue(const Program& program, std::uint64_t* launches)
    : queue_(program.context, program.device), launches_(launches) {
    const bool processor = program.entry.kind == "cpu";
    const auto largest = program.device.getInfo<CL_DEVICE_MAX_WORK_GROUP_SIZE>();
    const auto units = program.device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>();
    // One size for all launches: PoCL compiles a kernel anew for each.
    group_size_ =
        processor ? 1 : static_cast<std::uint32_t>(std::min<std::size_t>(kGraphicsGroup, largest));
    chunks_ = processor ? units * kProcessorChunks : 0;
}

std::uint32_t Queue::chunk_of(std::uint32_t draws) const {
    return chunks_ == 0 ? 1 : std::max(1u, draws / chunks_);
}

void Queue::launch_all(const cl::Kernel& kernel, std::uint32_t items) {
    const std::uint64_t groups = (std::uint64_t{items} + group_size_ - 1) / group_size_;
    queue_.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(groups * group_size_),
                                cl::NDRange(group_size_));
    if (launches_ != nullptr) ++*launches_;
}

void Queue::zero(const cl::Buffer& buffer, std::size_t words) {
    // Not clEnqueueFillBuffer: Oclgrind takes what it fills for uninitialized.
    static constexpr std::array<cl_uint, kPasses> kZeros{};
    queue_.enqueueWriteBuffer(buffer, CL_FALSE, 0, words * sizeof(cl_uint), kZeros.data());
}

// ------------------------------------------------------------------------------------ the memory

State::State(std::shared_ptr<Program> the_program, const Plan& the_plan,
             const device::Tuning& tuning, std::uint64_t* launches)
    : program(std::move(the_program)),
      queue(*program, launches),
      kernels(program->program),
      plan(the_plan),
      geometry(device::geometry_of(plan, count_columns(plan), 0)),
      largest_slab_bytes(tuning.largest_slab_bytes != 0 ? tuning.largest_slab_bytes
                                                        : program->entry.largest_buffer_bytes) {
    const std::uint64_t word = sizeof(cl_uint);
    span_counts = buffer(plan.lines * word);
    free_lengths = buffer(plan.lines * word);
    column_begins = buffer((geometry.columns + word) * word);
    near_begins = buffer((geometry.columns + word) * word);
    near_counts = buffer(geometry.columns * word);
    undecided = buffer(kPasses * word);
    overflow = buffer(word);

    // One span a line, written in a row, then spread out.
    allocate_slabs(1);
    for (std::size_t i = 0; i < slabs.size(); ++i)
        queue.write<Span>(spans[i], std::vector<Span>(slabs[i].lines(), Span{0, plan.height}));
    queue.write<std::uint32_t>(span_counts, std::vector<std::uint32_t>(plan.lines, 1));
    queue.write<std::uint32_t>(free_lengths, std::vector<std::uint32_t>(plan.lines, plan.height));
    grow(first_capacity(plan));
}

cl::Buffer State::buffer(std::uint64_t bytes) const {
    return {program->context, CL_MEM_READ_WRITE, std::max<std::size_t>(bytes, sizeof(cl_uint4))};
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
        candidates = buffer(std::uint64_t{count} * sizeof(Candidate));
        fates = buffer(std::uint64_t{count} * sizeof(cl_uint));
        samples = buffer(std::uint64_t{count} * sizeof(Sample));
        // Each lies near its own column and those on either side.
        near = buffer(std::uint64_t{count} * 3 * sizeof(Sample));
    }
    queue.write<std::uint32_t>(column_begins, host_column_begins);
    queue.write<std::uint32_t>(near_begins, host_near_begins);
    queue.zero(undecided, kPasses);
    queue.zero(overflow, 1);
}

Snapshot State::snapshot() {
    Snapshot snapshot{geometry.capacity, {}, {}, {}};
    snapshot.candidates.resize(draw_count);
    snapshot.fates.resize(draw_count);
    std::vector<std::uint32_t> counts(plan.lines);
    queue.start_read(candidates, std::span(snapshot.candidates));
    queue.start_read(fates, std::span(snapshot.fates));
    queue.start_read(span_counts, std::span(counts));
    queue.finish();
    for (std::size_t i = 0; i < slabs.size(); ++i) {
        std::vector<Span> slots(std::size_t{slabs[i].lines()} * geometry.capacity);
        queue.start_read(spans[i], std::span(slots));
        queue.finish();
        device::unpack(slabs[i], slots, counts, snapshot);
    }
    return snapshot;
}

void State::restore(const Snapshot& snapshot) {
    allocate_slabs(snapshot.capacity);
    for (std::size_t i = 0; i < slabs.size(); ++i)
        queue.write<Span>(spans[i], device::pack(slabs[i], snapshot));
    std::vector<std::uint32_t> counts, lengths;
    for (const std::vector<Span>& of_line : snapshot.spans) {
        counts.push_back(static_cast<std::uint32_t>(of_line.size()));
        lengths.push_back(0);
        for (const Span span : of_line) lengths.back() += span.end - span.begin;
    }
    queue.write<std::uint32_t>(span_counts, counts);
    queue.write<std::uint32_t>(free_lengths, lengths);

    find_column_begins(plan, geometry.columns, std::span(snapshot.candidates), host_column_begins);
    begin_round(static_cast<std::uint32_t>(snapshot.candidates.size()));
    queue.write<Candidate>(candidates, snapshot.candidates);
    queue.write<std::uint32_t>(fates, snapshot.fates);
    queue.write<Sample>(samples, device::samples_by_order(snapshot));
}

}  // namespace lacuna::opencl
