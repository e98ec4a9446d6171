// The vulkan backend's memory in mode cells, and what moves between it and the host.
#include "backends/vulkan/cells_state.h"

#include <algorithm>
#include <bit>

#include "backends/columns.h"
#include "backends/vulkan/transfer.h"
#include "plan/first_free.h"

namespace lacuna::vulkan {
namespace {

constexpr std::uint64_t kStagingWords = std::uint64_t{1} << 22;  // of bits on their way up

Buffer copy_on_device(Engine& engine, const std::vector<std::uint32_t>& values) {
    Buffer made = words_on_device(engine, values.size());
    write<std::uint32_t>(engine, made, values);
    return made;
}

}  // namespace

CellsState::CellsState(const Plan& the_plan, Engine& the_engine)
    : RoundMemory(the_plan, the_engine),
      first_lines(lacuna::first_lines(plan, geometry.columns)),
      words(words_per_line(plan)),
      bits(words_on_device(engine, std::uint64_t{plan.lines} * words)),
      free_lengths(copy_on_device(engine, first_free_lengths(plan))),
      widest(words_on_device(engine, plan.lines)),
      pixel_radii(copy_on_device(engine, plan.radii->radii)),
      pixel_reaches(copy_on_device(engine, plan.radii->reaches)),
      widest_rows(copy_on_device(engine, plan.radii->widest_rows)),
      column_of(copy_on_device(engine, plan.radii->column_of)),
      row_of(copy_on_device(engine, plan.radii->row_of)),
      row_begins(copy_on_device(engine, plan.radii->row_begins)),
      left_count(words_on_device(engine, 1)),
      free_lengths_down(host_copy_of(engine, free_lengths, Engine::Memory::download)),
      left_count_down(host_copy_of(engine, left_count, Engine::Memory::download)) {
    engine.fill(widest, 0, plan.lines * kWord);
    set_bits();
}

// Some lines at a time: the whole lattice may have a hundred megabytes.
void CellsState::set_bits() {
    const auto batch =
        static_cast<std::uint32_t>(std::clamp<std::uint64_t>(kStagingWords / words, 1, plan.lines));
    const Buffer staging =
        engine.allocate(Engine::Memory::upload, std::uint64_t{batch} * words * kWord);
    for (std::uint32_t first = 0; first < plan.lines; first += batch) {
        const std::uint32_t end = std::min(plan.lines, first + batch);
        const std::vector<std::uint32_t> of_lines = first_bits(plan, first, end);
        put(of_lines, staging);
        engine.copy(staging, bits, of_lines.size() * kWord, 0,
                    std::uint64_t{first} * words * kWord);
        engine.wait();
    }
}

void CellsState::make_candidate_room() {
    if (draw_count <= candidate_room_ && candidate_room_ != 0) return;
    candidate_room_ = draw_count;
    candidate_radii = words_on_device(engine, draw_count);
    todo = words_on_device(engine, draw_count);
    left = words_on_device(engine, draw_count);
}

void CellsState::upload(std::span<const Draw> the_draws) {
    RoundMemory::upload(the_draws, first_lines);
    make_candidate_room();
    engine.fill(left_count, 0, kWord);
    engine.barrier();
}

void CellsState::download() {
    RoundMemory::download();
    engine.copy(free_lengths, free_lengths_down, plan.lines * kWord);
    engine.copy(left_count, left_count_down, kWord);
}

Snapshot CellsState::snapshot() {
    Snapshot snapshot;
    snapshot_round(snapshot);
    snapshot.bits = read<std::uint32_t>(engine, bits, std::size_t{plan.lines} * words);
    return snapshot;
}

void CellsState::begin_restored(const Snapshot& snapshot) {
    write<std::uint32_t>(engine, bits, snapshot.bits);
    std::vector<std::uint32_t> lengths(plan.lines, 0);
    for (std::size_t i = 0; i < snapshot.bits.size(); ++i)
        lengths[i / words] += static_cast<std::uint32_t>(std::popcount(snapshot.bits[i]));
    write<std::uint32_t>(engine, free_lengths, lengths);
    engine.fill(widest, 0, plan.lines * kWord);
    begin_restored_round(snapshot);
    make_candidate_room();
    engine.fill(left_count, 0, kWord);
    engine.barrier();
}

}  // namespace lacuna::vulkan
