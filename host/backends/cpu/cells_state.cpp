// The cpu backend's memory in mode cells.
#include "backends/cpu/cells_state.h"

#include <algorithm>
#include <bit>

#include "backends/columns.h"
#include "plan/first_free.h"
#include "portable/fate.h"

namespace lacuna::cpu {

CellsState::CellsState(const Plan& the_plan)
    : plan(the_plan),
      radii(*plan.radii),
      columns(count_columns(plan)),
      first_lines(lacuna::first_lines(plan, columns)),
      widest(plan.lines, 0),
      words((plan.height + std::size_t{63}) / 64),
      bits(std::make_unique_for_overwrite<std::uint64_t[]>(plan.lines * words)),
      free_lengths(first_free_lengths(plan)),
      column_begins(columns + std::size_t{1}),
      near_begins(columns + std::size_t{1}) {}

void set_free(CellsState& state, std::uint32_t column) {
    const RadiusMap& radii = state.radii;
    for (std::uint32_t i = state.first_lines[column]; i < state.first_lines[column + 1]; ++i) {
        const std::span<std::uint64_t> line = state.line(i);
        // Lines above one column of pixels are alike.
        if (i > state.first_lines[column] && radii.column_of[i] == radii.column_of[i - 1]) {
            std::copy(state.line(i - 1).begin(), state.line(i - 1).end(), line.begin());
            continue;
        }
        std::fill(line.begin(), line.end(), 0);
        const std::uint32_t* const pixels =
            &radii.radii[std::size_t{radii.column_of[i]} * radii.rows];
        for (std::uint32_t row = 0; row < radii.rows; ++row)
            if (pixels[row] != 0)
                for (std::uint32_t y = radii.row_begins[row]; y < radii.row_begins[row + 1]; ++y)
                    line[y / 64] |= std::uint64_t{1} << (y % 64);
    }
}

void find_near(CellsState& state) {
    // Counted, then listed.
    std::vector<std::uint32_t>& begins = state.near_begins;
    const auto for_each_admitted = [&](auto visit) {
        for (std::uint32_t i = 0; i < state.candidates.size(); ++i)
            if (state.fates[i] == FATE_ADMITTED) visit(i);
    };
    std::fill(begins.begin(), begins.end(), 0);
    for_each_admitted([&](std::uint32_t i) {
        const Candidate& sample = state.candidates[i];
        state.for_each_column_near(sample.x, state.reach_of(sample),
                                   [&](std::uint32_t column) { ++begins[column]; });
    });
    std::uint32_t sum = 0;
    for (std::uint32_t& begin : begins) begin = sum += begin;
    state.near.resize(sum);
    for_each_admitted([&](std::uint32_t i) {
        const Candidate& sample = state.candidates[i];
        state.for_each_column_near(sample.x, state.reach_of(sample),
                                   [&](std::uint32_t column) { state.near[--begins[column]] = i; });
    });
}

Snapshot CellsState::snapshot() const {
    Snapshot snapshot;
    snapshot.candidates = candidates;
    snapshot.fates = fates;
    for (std::size_t i = 0; i < plan.lines * words; ++i) {
        snapshot.bits.push_back(static_cast<std::uint32_t>(bits[i]));
        snapshot.bits.push_back(static_cast<std::uint32_t>(bits[i] >> 32));
    }
    return snapshot;
}

void CellsState::restore(const Snapshot& snapshot) {
    for (std::size_t i = 0; i < plan.lines * words; ++i)
        bits[i] = std::uint64_t{snapshot.bits[2 * i + 1]} << 32 | snapshot.bits[2 * i];
    for (std::uint32_t i = 0; i < plan.lines; ++i) {
        free_lengths[i] = 0;
        for (const std::uint64_t word : line(i))
            free_lengths[i] += static_cast<std::uint32_t>(std::popcount(word));
    }
    std::fill(widest.begin(), widest.end(), 0);
    candidates = snapshot.candidates;
    fates = snapshot.fates;
    candidate_radii.clear();
    for (const Candidate& candidate : candidates)
        candidate_radii.push_back(radii.radii[radii.pixel_at(candidate.x, candidate.y)]);
    find_column_begins(plan, columns, candidates, column_begins);
}

}  // namespace lacuna::cpu
