// What the cpu backend keeps: lines with free spans, then boxes; and the candidates of the round.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "backends/backend.h"
#include "backends/cpu/sample_grid.h"
#include "plan/plan.h"

namespace lacuna::cpu {

struct State {
    explicit State(const Plan& plan);

    const Plan& plan;
    std::uint32_t columns;                   // of lines, see portable/column.h
    std::vector<std::uint32_t> first_lines;  // of each column; columns + 1

    // Line i's free spans are the first span_counts[i] of slot(i): sorted, disjoint, none empty.
    // Let go of at the first refinement.
    std::uint32_t capacity;
    std::unique_ptr<Span[]> spans;
    std::vector<std::uint32_t> span_counts;

    // In exact: the samples so far and, from the first refinement on, each column's boxes.
    std::optional<SampleGrid> grid;
    std::uint32_t box_width = 0;  // 0 before
    std::vector<std::vector<Box>> boxes;

    // The places draws fall on, which are lines, then boxes: the first of each column, columns + 1;
    // and their free lengths.
    std::vector<std::uint32_t> place_begins;
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
    bool has_boxes() const { return box_width != 0; }
    std::uint32_t place_width() const { return has_boxes() ? box_width : plan.strip_width; }
    // Twice the room for every line.
    void grow();
    Snapshot snapshot() const;
    void restore(const Snapshot& snapshot);

private:
    void restore_spans(const Snapshot& snapshot);
    void restore_boxes(const Snapshot& snapshot);
};

// The verbs, a column at a time; any order, in parallel.

// Turns the column's draws into candidates.
void locate(State& state, std::span<const Draw> draws, std::uint32_t column);

// In exact, before the column is first admitted: settles the candidates that samples of earlier
// rounds cover.
void screen(State& state, std::uint32_t column);

// Settles what can be settled of the column's undecided candidates; true when all are. Several
// passes settle all: the earliest undecided candidate never waits for another.
bool admit(State& state, std::uint32_t column);

// Puts the column's samples of this round into the grid.
void insert(State& state, std::uint32_t column);

// Cuts the round's chords from the column's lines. False when a line ran out of room: nothing is
// lost, and after grow() the same call completes the work.
bool subtract(State& state, std::uint32_t column);

// Replaces the column's places by what all samples near them leave of them, `width` wide: its own
// places' width, or half of it.
void refine(State& state, std::uint32_t column, std::uint32_t width);

}  // namespace lacuna::cpu
