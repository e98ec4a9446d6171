// What the cpu backend keeps in mode cells: the lattice's bits, and the candidates of the round.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "backends/backend.h"
#include "plan/plan.h"

namespace lacuna::cpu {

struct CellsState {
    explicit CellsState(const Plan& plan);

    const Plan& plan;
    const RadiusMap& radii;
    std::uint32_t columns;                   // of lines, see portable/column.h
    std::vector<std::uint32_t> first_lines;  // of each column; columns + 1

    // With mean and max, where in RadiusMap::widest_rows of its pixels a line's first row is that
    // may have a free point. Goes up as points are blocked.
    std::vector<std::uint32_t> widest;

    // Bit y of a line is set while its lattice point is free.
    std::size_t words;  // of each line
    std::unique_ptr<std::uint64_t[]> bits;
    std::vector<std::uint32_t> free_lengths;

    // The round's candidates, column by column, by y within a column; the radius of each, what
    // became of it, and where it is in the order of the draws.
    std::vector<Candidate> candidates;
    std::vector<std::uint32_t> candidate_radii;
    std::vector<std::uint32_t> column_begins;  // columns + 1
    std::vector<std::uint32_t> fates;          // portable/fate.h

    // The candidates admitted that may reach each column: near[near_begins[column]] and on.
    std::vector<std::uint32_t> near_begins;
    std::vector<std::uint32_t> near;

    std::span<std::uint64_t> line(std::uint32_t index) const {
        return {&bits[index * words], words};
    }
    std::span<const Candidate> candidates_of(std::uint32_t column) const {
        return {candidates.data() + column_begins[column],
                column_begins[column + 1] - column_begins[column]};
    }
    // How far a conflict with the candidate may be, in lattice steps.
    std::uint32_t reach_of(const Candidate& candidate) const {
        return radii.reaches[radii.pixel_at(candidate.x, candidate.y)];
    }
    // Calls visit(column) for the columns within `reach` of x, around the torus, each once.
    template <typename Visit>
    void for_each_column_near(std::uint32_t x, std::uint32_t reach, Visit visit) const;

    Snapshot snapshot() const;
    void restore(const Snapshot& snapshot);
};

template <typename Visit>
void CellsState::for_each_column_near(std::uint32_t x, std::uint32_t reach, Visit visit) const {
    const auto column_of = [&](std::uint32_t line) {
        return static_cast<std::uint32_t>(std::uint64_t{line} * columns / plan.lines);
    };
    const bool wraps = plan.period_x != 0;
    if (!wraps || 2 * std::uint64_t{reach} + 1 < plan.lines) {
        const std::uint32_t low = column_of(x >= reach ? x - reach : 0);
        const std::uint32_t high = column_of(std::min(x + reach, plan.lines - 1));
        for (std::uint32_t column = low; column <= high; ++column) visit(column);
        if (!wraps) return;
        // What sticks out at one end comes in at the other; the column there may be low or high.
        if (x < reach)
            for (std::uint32_t column = std::max(high + 1, column_of(x + plan.lines - reach));
                 column < columns; ++column)
                visit(column);
        if (x + reach >= plan.lines) {
            const std::uint32_t last = column_of(x + reach - plan.lines);
            for (std::uint32_t column = 0; column <= last && column < low; ++column) visit(column);
        }
        return;
    }
    for (std::uint32_t column = 0; column < columns; ++column) visit(column);
}

// The verbs, a column at a time; any order, in parallel. See cpu/state.h.
void set_free(CellsState& state, std::uint32_t column);
void locate(CellsState& state, std::span<const Draw> draws, std::uint32_t column);
bool admit(CellsState& state, std::uint32_t column);
void subtract(CellsState& state, std::uint32_t column);

// For subtract: finds the candidates admitted that may reach each column. Sequential.
void find_near(CellsState& state);

}  // namespace lacuna::cpu
