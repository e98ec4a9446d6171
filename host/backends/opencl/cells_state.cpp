// The opencl backend's memory in mode cells.
#include "backends/opencl/cells_state.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <utility>

#include "plan/first_free.h"

namespace lacuna::opencl {

CellsKernels::CellsKernels(const cl::Program& program)
    : locate_in_cells(program, "locate_in_cells"),
      sort_columns(program, "sort_columns"),
      look_up_radii(program, "look_up_radii"),
      admit_in_cells(program, "admit_in_cells"),
      subtract_in_cells(program, "subtract_in_cells") {}

CellsState::CellsState(std::shared_ptr<Program> the_program, const Plan& the_plan,
                       std::uint64_t* launches)
    : RoundMemory(std::move(the_program), the_plan, launches),
      kernels(program->program),
      words(words_per_line(plan)),
      rows(plan.radii->rows),
      metric(static_cast<std::uint32_t>(plan.metric)),
      pixel_radii(copy_of(plan.radii->radii)),
      pixel_reaches(copy_of(plan.radii->reaches)),
      widest_rows(copy_of(plan.radii->widest_rows)),
      column_of(copy_of(plan.radii->column_of)),
      row_of(copy_of(plan.radii->row_of)),
      row_begins(copy_of(plan.radii->row_begins)),
      bits(words_on_device(std::uint64_t{plan.lines} * words)),
      widest(words_on_device(plan.lines)) {
    free_lengths = copy_of(first_free_lengths(plan));
    queue.fill(widest, plan.lines, 0);
    write_first_bits();
}

cl::Buffer CellsState::copy_of(std::span<const std::uint32_t> values) {
    cl::Buffer copy = words_on_device(values.size());
    queue.write(copy, values);
    return copy;
}

// A part at a time: a lattice may have as many points as the device has room for.
void CellsState::write_first_bits() {
    constexpr std::uint32_t kPartWords = 1 << 20;
    const std::uint32_t step = std::max(kPartWords / words, 1u);
    for (std::uint32_t line = 0; line < plan.lines; line += step) {
        const std::uint32_t end = line + std::min(step, plan.lines - line);
        queue.write_words(bits, std::uint64_t{line} * words, first_bits(plan, line, end));
    }
}

void CellsState::queue_radii() {
    if (candidate_room_ < draw_count || candidate_room_ == 0) {
        candidate_room_ = draw_count;
        candidate_radii = words_on_device(draw_count);
    }
    const std::uint32_t chunk = queue.chunk_of(draw_count);
    queue.launch_in_slices(kernels.look_up_radii, items_of(draw_count, chunk), draw_count, rows,
                           draw_count, chunk, candidates, column_of, row_of, pixel_radii,
                           candidate_radii);
}

Snapshot CellsState::snapshot() {
    Snapshot snapshot;
    snapshot_round(snapshot);
    snapshot.bits.resize(std::size_t{plan.lines} * words);
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
    queue.fill(widest, plan.lines, 0);
    restore_round(snapshot);
    queue_radii();
}

}  // namespace lacuna::opencl
