// What the cpu backend keeps: the lines' free spans, and the candidates of the round.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "backend.h"
#include "plan.h"

namespace lacuna::cpu {

struct State {
    explicit State(const Plan& plan);

    const Plan& plan;
    std::uint32_t columns;  // of lines, see portable/column.h

    // Line i's free spans are the first span_counts[i] of slot(i): sorted, disjoint, none empty.
    std::uint32_t capacity;
    std::unique_ptr<Span[]> spans;
    std::vector<std::uint32_t> span_counts;
    std::vector<std::uint32_t> free_lengths;

    // The round's candidates, column by column, by y within a column; and what became of them.
    std::vector<Candidate> candidates;
    std::vector<std::uint32_t> column_begins;  // columns + 1
    std::vector<std::uint32_t> fates;          // portable/fate.h

    std::span<Span> slot(std::uint32_t line) const {
        return {spans.get() + std::size_t{line} * capacity, capacity};
    }
    std::span<const Candidate> candidates_of(std::uint32_t column) const {
        return {candidates.data() + column_begins[column],
                column_begins[column + 1] - column_begins[column]};
    }
    std::uint32_t first_line(std::uint32_t column) const;
    // Twice the room for every line.
    void grow();
    void restore(const Snapshot& snapshot);
};

// The verbs, a column at a time; any order, in parallel.

// Turns the column's draws into candidates.
void locate(State& state, std::span<const Draw> draws, std::uint32_t column);

// Settles what can be settled of the column's undecided candidates; true when all are. Several
// passes settle all: the earliest undecided candidate never waits for another.
bool admit(State& state, std::uint32_t column);

// Cuts the round's chords from the column's lines. False when a line ran out of room: nothing is
// lost, and after grow() the same call completes the work.
bool subtract(State& state, std::uint32_t column);

}  // namespace lacuna::cpu
