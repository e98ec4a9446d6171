// What every mode keeps on the device of a round, and what moves between it and the host.
#include "backends/opencl/round_memory.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "backends/columns.h"
#include "backends/device/layout.h"

namespace lacuna::opencl {

RoundMemory::RoundMemory(std::shared_ptr<Program> the_program, const Plan& the_plan,
                         std::uint64_t* launches)
    : program(std::move(the_program)),
      queue(*program, launches),
      plan(the_plan),
      geometry(device::geometry_of(plan, count_columns(plan), 0)),
      place_count(plan.lines),
      host_place_begins(first_lines(plan, geometry.columns)),
      column_begins(words_on_device(geometry.columns + std::uint64_t{1})),
      undecided(words_on_device(kPasses)),
      failure(words_on_device(1)) {
    zero(undecided, kPasses);
    zero(failure, 1);
}

cl::Buffer RoundMemory::on_device(std::uint64_t bytes) const {
    return {program->context, CL_MEM_READ_WRITE, std::max<std::size_t>(bytes, sizeof(cl_uint4))};
}

cl::Buffer RoundMemory::words_on_device(std::uint64_t count) const {
    return on_device(count * sizeof(cl_uint));
}

void RoundMemory::zero(const cl::Buffer& of, std::uint32_t count) {
    static constexpr std::array<std::uint32_t, kPasses> kZeros{};
    queue.start_write(of, std::span(kZeros).first(count));
}

// What the buffers of a round held is lost when they grow: a round writes before it reads.
void RoundMemory::make_room(std::uint32_t count) {
    if (count <= draw_room_ && draw_room_ != 0) return;
    draw_room_ = count;
    draws = on_device(std::uint64_t{count} * sizeof(Draw));
    located = on_device(std::uint64_t{count} * sizeof(Candidate));
    buckets = words_on_device(count);
    candidates = on_device(std::uint64_t{count} * sizeof(Candidate));
    fates = words_on_device(count);
    pending = words_on_device(count);
    samples = on_device(std::uint64_t{count} * sizeof(Sample));
}

// Expects host_column_begins.
void RoundMemory::begin_round(std::uint32_t count) {
    draw_count = count;
    make_room(count);
    queue.start_write<std::uint32_t>(column_begins, host_column_begins);
    zero(undecided, kPasses);
    zero(failure, 1);
}

void RoundMemory::upload(std::span<const Draw> the_draws) {
    find_column_begins(host_place_begins, the_draws, host_column_begins);
    begin_round(static_cast<std::uint32_t>(the_draws.size()));
    queue.write(draws, the_draws);
}

void RoundMemory::sort(cl::Kernel& sort_columns) {
    queue.launch_in_slices(sort_columns, geometry.columns, draw_count, geometry, column_begins,
                           located, buckets, candidates, fates, pending, failure);
}

void RoundMemory::begin_passes(std::uint32_t first_pass) {
    static constexpr std::array<std::uint32_t, kPasses> kUnsettled = {1};
    if (first_pass == 1)
        queue.start_write<std::uint32_t>(undecided, kUnsettled);
    else
        zero(undecided, kPasses);
}

void RoundMemory::read_flags() {
    queue.start_read<std::uint32_t>(undecided, host_undecided_);
    queue.start_read<std::uint32_t>(failure, host_failure_);
    queue.finish();
    if (host_failure_.front() != 0) throw kernel_error(host_failure_.front(), program->entry.name);
}

// --------------------------------------------------------------------------------- for tests only

void RoundMemory::snapshot_round(Snapshot& snapshot) {
    snapshot.capacity = geometry.capacity;
    snapshot.candidates.resize(draw_count);
    snapshot.fates.resize(draw_count);
    queue.start_read(candidates, std::span(snapshot.candidates));
    queue.start_read(fates, std::span(snapshot.fates));
    queue.drain();
}

void RoundMemory::restore_round(const Snapshot& snapshot) {
    find_column_begins(plan, geometry.columns, std::span(snapshot.candidates), host_column_begins);
    begin_round(static_cast<std::uint32_t>(snapshot.candidates.size()));
    queue.write<Candidate>(candidates, snapshot.candidates);
    queue.write<std::uint32_t>(fates, snapshot.fates);
    queue.write<std::uint32_t>(pending,
                               device::pending_of(snapshot.fates, queue.chunk_of(draw_count)));
    queue.write<Sample>(samples, device::samples_by_order(snapshot));
}

}  // namespace lacuna::opencl
