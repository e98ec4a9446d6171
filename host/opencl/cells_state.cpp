// The opencl backend's memory in mode cells.
#include "opencl/cells_state.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <utility>

#include "columns.h"
#include "device/cells_layout.h"
#include "device/layout.h"

namespace lacuna::opencl {

CellsKernels::CellsKernels(const cl::Program& program)
    : locate_in_cells(program, "locate_in_cells"),
      sort_columns(program, "sort_columns"),
      look_up_radii(program, "look_up_radii"),
      admit_in_cells(program, "admit_in_cells"),
      subtract_in_cells(program, "subtract_in_cells") {}

CellsState::CellsState(std::shared_ptr<Program> the_program, const Plan& the_plan,
                       std::uint64_t* launches)
    : program(std::move(the_program)),
      queue(*program, launches),
      kernels(program->program),
      plan(the_plan),
      geometry(device::geometry_of(plan, count_columns(plan), 0)),
      words(device::words_per_line(plan)),
      rows(plan.radii->rows),
      metric(static_cast<std::uint32_t>(plan.metric)),
      first_lines(lacuna::first_lines(plan, geometry.columns)),
      pixel_radii(copy_of(plan.radii->radii)),
      pixel_reaches(copy_of(plan.radii->reaches)),
      column_of(copy_of(plan.radii->column_of)),
      row_of(copy_of(plan.radii->row_of)),
      row_begins(copy_of(plan.radii->row_begins)),
      bits(words_of(std::uint64_t{plan.lines} * words)),
      free_lengths(copy_of(plan.radii->free_lengths())),
      column_begins(words_of(geometry.columns + std::uint64_t{1})),
      undecided(copy_of(host_undecided)),
      failure(copy_of(host_failure)) {
    write_first_bits();
}

cl::Buffer CellsState::buffer(std::uint64_t bytes) const {
    return {program->context, CL_MEM_READ_WRITE, std::max<std::size_t>(bytes, sizeof(cl_uint4))};
}

cl::Buffer CellsState::words_of(std::uint64_t count) const {
    return buffer(count * sizeof(cl_uint));
}

cl::Buffer CellsState::copy_of(std::span<const std::uint32_t> values) {
    cl::Buffer copy = words_of(values.size());
    queue.write(copy, values);
    return copy;
}

// A part at a time: a lattice may have as many points as the device has room for.
void CellsState::write_first_bits() {
    constexpr std::uint32_t kPartWords = 1 << 20;
    const std::uint32_t step = std::max(kPartWords / words, 1u);
    for (std::uint32_t line = 0; line < plan.lines; line += step) {
        const std::uint32_t end = line + std::min(step, plan.lines - line);
        queue.write_words(bits, std::uint64_t{line} * words, device::first_bits(plan, line, end));
    }
}

void CellsState::begin_round(std::uint32_t count) {
    draw_count = count;
    if (draw_room < count || draw_room == 0) {
        draw_room = count;
        draws = buffer(std::uint64_t{count} * sizeof(Draw));
        located = buffer(std::uint64_t{count} * sizeof(Candidate));
        buckets = words_of(count);
        candidates = buffer(std::uint64_t{count} * sizeof(Candidate));
        candidate_radii = words_of(count);
        fates = words_of(count);
        pending = words_of(count);
        samples = buffer(std::uint64_t{count} * sizeof(Sample));
    }
    static constexpr std::array<std::uint32_t, kPasses> kZeros{};
    queue.start_write<std::uint32_t>(column_begins, host_column_begins);
    queue.start_write<std::uint32_t>(undecided, kZeros);
    queue.start_write(failure, std::span(kZeros).first(1));
}

void CellsState::queue_radii() {
    const std::uint32_t chunk = queue.chunk_of(draw_count);
    queue.launch_in_slices(kernels.look_up_radii, items_of(draw_count, chunk), draw_count, rows,
                           draw_count, chunk, candidates, column_of, row_of, pixel_radii,
                           candidate_radii);
}

void CellsState::read_flags() {
    queue.start_read<std::uint32_t>(undecided, host_undecided);
    queue.start_read<std::uint32_t>(failure, host_failure);
    queue.finish();
    if (host_failure.front() != 0) throw kernel_error(host_failure.front(), program->entry.name);
}

Snapshot CellsState::snapshot() {
    Snapshot snapshot;
    snapshot.candidates.resize(draw_count);
    snapshot.fates.resize(draw_count);
    snapshot.bits.resize(std::size_t{plan.lines} * words);
    queue.start_read(candidates, std::span(snapshot.candidates));
    queue.start_read(fates, std::span(snapshot.fates));
    queue.start_read(bits, std::span(snapshot.bits));
    queue.drain();
    return snapshot;
}

void CellsState::restore(const Snapshot& snapshot) {
    std::vector<std::uint32_t> lengths(plan.lines, 0);
    for (std::size_t i = 0; i < snapshot.bits.size(); ++i)
        lengths[i / words] += static_cast<std::uint32_t>(std::popcount(snapshot.bits[i]));
    queue.write<std::uint32_t>(bits, snapshot.bits);
    queue.write<std::uint32_t>(free_lengths, lengths);

    find_column_begins(plan, geometry.columns, std::span(snapshot.candidates), host_column_begins);
    begin_round(static_cast<std::uint32_t>(snapshot.candidates.size()));
    queue.write<Candidate>(candidates, snapshot.candidates);
    queue.write<std::uint32_t>(fates, snapshot.fates);
    queue.write<std::uint32_t>(pending,
                               device::pending_of(snapshot.fates, queue.chunk_of(draw_count)));
    queue.write<Sample>(samples, device::samples_by_order(snapshot));
    queue_radii();
}

}  // namespace lacuna::opencl
