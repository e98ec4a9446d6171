// The cpu backend's memory. All modes have columns of lines and the round's candidates; the bins of
// a mode are spans and boxes, or bits.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "backends/backend.h"
#include "backends/cpu/sample_grid.h"
#include "plan/plan.h"

namespace lacuna::cpu {

// How far the round has come.
enum class Stage {
    none,      // there was no round yet, and the bins are not set free
    restored,  // candidates with any statuses
    located,   // undecided candidates; in exact, screen has found those that are covered
    admitted,  // all are decided; in exact, the round's samples are in the grid or the lists
    cut,       // the round's samples are cut from the bins
};

// The order of candidates within a column.
inline bool comes_before(const Candidate& a, const Candidate& b) {
    return a.y < b.y || (a.y == b.y && a.order < b.order);
}

struct State {
    // With columns of lines.
    explicit State(const Plan& plan);
    // With a radius field, where regions stand for columns. region_begins: the first box of each,
    // then the number of boxes.
    State(const Plan& plan, std::vector<std::uint32_t> region_begins);

    const Plan& plan;
    std::uint32_t columns;                   // number of columns, see portable/column.h
    std::vector<std::uint32_t> first_lines;  // of each column, then the number of lines

    // The bins that draws fall on: the first of each column, then the number of bins; and their
    // free lengths.
    std::uint32_t bin_width;
    std::vector<std::uint32_t> bin_begins;
    std::vector<std::uint32_t> free_lengths;
    std::vector<std::uint32_t> bin_widths;  // of each bin, with a radius field only
    std::vector<std::uint32_t> sheet_ends;  // with classes, as in Round

    // The round's candidates, column by column, and their statuses. Within a column they are sorted
    // by y; in exact they keep the order of their draws, which is by bin.
    std::vector<Candidate> candidates;
    std::vector<std::uint32_t> column_begins;  // columns + 1
    std::vector<std::uint32_t> statuses;       // portable/status.h
    std::vector<std::uint32_t> by_order;       // the candidate of each draw
    // Except in exact, a column has as many buckets as candidates (portable/column.h). Bucket b
    // begins at the column's candidate number buckets[column_begins[column] + b].
    std::vector<std::uint32_t> buckets;

    std::span<const Candidate> candidates_of(std::uint32_t column) const {
        return {candidates.data() + column_begins[column],
                column_begins[column + 1] - column_begins[column]};
    }
    void make_room(std::size_t count);
    // Enters the column's candidates into by_order.
    void find_orders(std::uint32_t column);
    // Makes room for the draws' candidates, and finds where each column's begin.
    void begin_round(std::span<const Draw> draws);
    // Sorts the column's candidates by y, and by order where y is equal.
    void sort_column(std::uint32_t column);
    // Called after all columns' candidates were located.
    void end_locate() {}
    // Index of the column's first candidate that is not below y, or the column's end.
    std::uint32_t first_from(std::uint32_t column, std::uint32_t y) const;
    // The number of the column's candidates in the buckets of the heights [low, high).
    std::uint32_t count_between(std::uint32_t column, std::uint32_t low, std::uint32_t high) const;

    Snapshot snapshot(Stage stage) const;
    void restore(const Snapshot& snapshot);
};

// Modes lines and exact: free spans of lines, and in exact later boxes.
struct SpanState : State {
    explicit SpanState(const Plan& plan);

    // Line i's free spans are the first span_counts[i] of slot(i): sorted, disjoint, none empty.
    // Freed at the first cut.
    std::uint32_t capacity;
    std::unique_ptr<Span[]> spans;
    std::vector<std::uint32_t> span_counts;

    // In exact: all samples; and, from the first cut on, each column's boxes.
    std::optional<SampleGrid> grid;
    bool has_boxes = false;
    std::vector<std::vector<Box>> boxes;

    std::span<Span> slot(std::uint32_t line) const {
        return {spans.get() + std::size_t{line} * capacity, capacity};
    }
    // Sets the line's spans, for which there must be room.
    void set_spans(std::uint32_t line, std::span<const Span> of_line);
    // Doubles the room of every line.
    void grow();
    // Makes the boxes the bins; all are `width` wide.
    void settle_boxes(std::uint32_t width);
    Snapshot snapshot(Stage stage) const;
    void restore(const Snapshot& snapshot);

private:
    void sort_columns(Snapshot& snapshot) const;
};

// In cells: the largest radius in each column, and in each block of kBlock columns. A candidate
// with a long reach skips the columns where all radii are small.
struct WidestRadii {
    static constexpr std::uint32_t kBlock = 64;

    std::vector<std::uint32_t> of_columns;
    std::vector<std::uint32_t> of_blocks;

    // Computes of_blocks from of_columns.
    void find_blocks();
};

// Mode cells: a bit for each lattice point.
struct BitState : State {
    explicit BitState(const Plan& plan);

    const RadiusMap& radii;

    // Bit y of a line is set while its lattice point is free.
    std::size_t words;  // of each line
    std::unique_ptr<std::uint64_t[]> bits;
    // With mean and max, for each line: the index in RadiusMap::widest_rows of the first row, in
    // the line's column of pixels, that may still have a free point. It goes up as points are
    // blocked.
    std::vector<std::uint32_t> widest;

    // The radius of each candidate, and the largest ones.
    std::vector<std::uint32_t> candidate_radii;
    WidestRadii widest_candidates;
    // Indices of the admitted candidates that may reach column c: near[near_begins[c]] up to
    // near[near_begins[c + 1]].
    std::vector<std::uint32_t> near_begins;
    std::vector<std::uint32_t> near;
    WidestRadii widest_open;  // radii of points that may still be free

    std::span<std::uint64_t> line(std::uint32_t index) const {
        return {&bits[index * words], words};
    }
    // The greatest distance of a conflict with the candidate, in lattice steps.
    std::uint32_t reach_of(const Candidate& candidate) const {
        return radii.reaches[radii.pixel_at(candidate.x, candidate.y)];
    }
    void make_room(std::size_t count);
    void begin_round(std::span<const Draw> draws);
    // Sets the line's bits from words of 32 bits.
    void set_bits(std::uint32_t line, std::span<const std::uint32_t> of_line);
    void find_radii(std::uint32_t column);
    void end_locate() { widest_candidates.find_blocks(); }
    // Computes widest_open from `widest`.
    void find_widest_open();
    // For subtract: fills near. Sequential; calls poll now and then, which may throw.
    void find_near(const std::function<void()>& poll);
    Snapshot snapshot(Stage stage) const;
    void restore(const Snapshot& snapshot);
};

// The verbs, one column a call: in any order, and in parallel.

// Before the first round: makes all of the column free.
void set_free(SpanState& state, std::uint32_t column);
void set_free(BitState& state, std::uint32_t column);

// Turns the column's draws into candidates.
void locate(SpanState& state, std::span<const Draw> draws, std::uint32_t column);
void locate(BitState& state, std::span<const Draw> draws, std::uint32_t column);

// Prepares the column's candidates for admit: sorts them, except in exact, and sets them undecided.
void set_undecided(SpanState& state, std::uint32_t column);
void set_undecided(BitState& state, std::uint32_t column);

// In exact, ahead of admit: finds the candidates that samples of earlier rounds cover.
void screen(SpanState& state, std::uint32_t column);

// In lines and cells: decides the column's undecided candidates where possible; true when all are
// decided. A few passes decide all: the earliest undecided candidate waits for no other. In exact
// see darts.h.
bool admit(SpanState& state, std::uint32_t column);
bool admit(BitState& state, std::uint32_t column);

// In lines and cells: whether the candidate's point was cut from its bin.
bool is_covered(const SpanState& state, const Candidate& candidate);
bool is_covered(const BitState& state, const Candidate& candidate);

// In lines and cells: the number of draws that admit decides first: all, unless the round crowds
// (crowd.h). Then each of them has few others within its reach.
std::uint32_t first_part(const SpanState& state);
std::uint32_t first_part(const BitState& state);

// In exact: puts the column's samples of this round into the grid.
void insert(SpanState& state, std::uint32_t column);

// Cuts the round's chords from the column's lines. False when a line ran out of room: nothing is
// lost, and after grow() the same call completes the work.
bool subtract(SpanState& state, std::uint32_t column);
// Blocks the column's lattice points that fail the metric with a sample of the round.
void subtract(BitState& state, std::uint32_t column);

// Replaces the column's bins by the pieces that the samples near them leave, as boxes of this
// width: the bins' own width, or half of it.
void refine(SpanState& state, std::uint32_t column, std::uint32_t width);

}  // namespace lacuna::cpu
