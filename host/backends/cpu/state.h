// What the cpu backend keeps: in all modes columns of lines and the candidates of a round; then the
// places of each mode, which are spans and boxes, or bits.
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

// The order of a column's candidates.
inline bool comes_before(const Candidate& a, const Candidate& b) {
    return a.y < b.y || (a.y == b.y && a.order < b.order);
}

struct State {
    // Columns of lines.
    explicit State(const Plan& plan);
    // With a radius field: regions, of which these are the first boxes.
    State(const Plan& plan, std::vector<std::uint32_t> region_begins);

    const Plan& plan;
    std::uint32_t columns;                   // of lines, see portable/column.h
    std::vector<std::uint32_t> first_lines;  // of each column; columns + 1

    // The places draws fall on: the first of each column, columns + 1; and their free lengths.
    std::uint32_t bin_width;
    std::vector<std::uint32_t> bin_begins;
    std::vector<std::uint32_t> free_lengths;
    std::vector<std::uint32_t> bin_widths;  // with a radius field only: of each

    // The round's candidates, column by column, and what became of them. Within a column they are
    // sorted by y; in exact they are as their draws were, place by place.
    std::vector<Candidate> candidates;
    std::vector<std::uint32_t> column_begins;  // columns + 1
    std::vector<std::uint32_t> statuses;       // portable/status.h
    std::vector<std::uint32_t> by_order;       // the candidate of each draw
    // In exact: candidates that earlier samples cover are settled, ahead of admit.
    bool is_screened = false;
    // But in exact, a column has as many buckets as candidates (portable/column.h). Bucket b of the
    // column begins at its candidate number buckets[column_begins[column] + b].
    std::vector<std::uint32_t> buckets;

    std::span<const Candidate> candidates_of(std::uint32_t column) const {
        return {candidates.data() + column_begins[column],
                column_begins[column + 1] - column_begins[column]};
    }
    // Room for so many candidates.
    void make_room(std::size_t count);
    // Notes which draws the column's candidates are.
    void find_orders(std::uint32_t column);
    // For the draws' candidates; and finds where each column's begin.
    void begin_round(std::span<const Draw> draws);
    // Sorts the column's candidates by y, and by order where y is equal.
    void sort_column(std::uint32_t column);
    // After all columns' candidates were sorted.
    void end_locate() {}
    // The column's first candidate that is not below y, or its end.
    std::uint32_t first_from(std::uint32_t column, std::uint32_t y) const;
    // How many of the column's candidates share a bucket with the heights [low, high).
    std::uint32_t count_between(std::uint32_t column, std::uint32_t low, std::uint32_t high) const;

    Snapshot snapshot() const;
    void restore(const Snapshot& snapshot);
};

// Modes lines and exact: lines, then in exact boxes.
struct SpanState : State {
    explicit SpanState(const Plan& plan);

    // Line i's free spans are the first span_counts[i] of slot(i): sorted, disjoint, none empty.
    // Let go of at the first refinement.
    std::uint32_t capacity;
    std::unique_ptr<Span[]> spans;
    std::vector<std::uint32_t> span_counts;

    // In exact: the samples so far, with the round's own once they are inserted; and, from the
    // first refinement on, each column's boxes.
    std::optional<SampleGrid> grid;
    bool is_inserted = false;
    bool has_boxes = false;
    std::vector<std::vector<Box>> boxes;

    std::span<Span> slot(std::uint32_t line) const {
        return {spans.get() + std::size_t{line} * capacity, capacity};
    }
    // Sets the line's spans, for which there must be room.
    void set_spans(std::uint32_t line, std::span<const Span> of_line);
    void end_locate() { is_screened = grid.has_value(); }
    // Twice the room for every line.
    void grow();
    // From now on the boxes are the places, all so wide.
    void settle_boxes(std::uint32_t width);
    Snapshot snapshot() const;
    void restore(const Snapshot& snapshot);

private:
    void sort_columns(Snapshot& snapshot) const;
};

// In cells: the widest radius of something in each column, and in each block of so many columns: a
// sample whose reach is long need not look at columns that have but small ones.
struct WidestRadii {
    static constexpr std::uint32_t kBlock = 64;

    std::vector<std::uint32_t> of_columns;
    std::vector<std::uint32_t> of_blocks;

    // From those of the columns.
    void find_blocks();
};

// Mode cells: a bit for each lattice point.
struct BitState : State {
    explicit BitState(const Plan& plan);

    const RadiusMap& radii;

    // Bit y of a line is set while its lattice point is free.
    std::size_t words;  // of each line
    std::unique_ptr<std::uint64_t[]> bits;
    // With mean and max, of each line: where in RadiusMap::widest_rows of the line's pixels the
    // first row stands that may still have a free point. Goes up as points are blocked.
    std::vector<std::uint32_t> widest;

    // The radius of each candidate, and the widest.
    std::vector<std::uint32_t> candidate_radii;
    WidestRadii widest_candidates;
    // The candidates admitted that may reach each column: near[near_begins[column]] and on.
    std::vector<std::uint32_t> near_begins;
    std::vector<std::uint32_t> near;
    WidestRadii widest_open;  // of points that may still be free

    std::span<std::uint64_t> line(std::uint32_t index) const {
        return {&bits[index * words], words};
    }
    // How far a conflict with the candidate may be, in lattice steps.
    std::uint32_t reach_of(const Candidate& candidate) const {
        return radii.reaches[radii.pixel_at(candidate.x, candidate.y)];
    }
    void make_room(std::size_t count);
    void begin_round(std::span<const Draw> draws);
    // Sets the line's bits from words of 32.
    void set_bits(std::uint32_t line, std::span<const std::uint32_t> of_line);
    // Looks up the radii of the column's candidates.
    void find_radii(std::uint32_t column);
    void end_locate() { widest_candidates.find_blocks(); }
    // What the widest rows of the lines tell.
    void find_widest_open();
    // For subtract: finds which candidates admitted may reach each column. Sequential; calls poll
    // now and then, which may throw.
    void find_near(const std::function<void()>& poll);
    Snapshot snapshot() const;
    void restore(const Snapshot& snapshot);
};

// The verbs, a column at a time; any order, in parallel.

// Before the first round: all places of the column are free.
void set_free(SpanState& state, std::uint32_t column);
void set_free(BitState& state, std::uint32_t column);

// Turns the column's draws into candidates.
void locate(SpanState& state, std::span<const Draw> draws, std::uint32_t column);
void locate(BitState& state, std::span<const Draw> draws, std::uint32_t column);

// Leaves the column's candidates as admit takes them: sorted, and undecided.
void set_undecided(SpanState& state, std::uint32_t column);
void set_undecided(BitState& state, std::uint32_t column);

// In exact, before the column is first admitted: settles the candidates that samples of earlier
// rounds cover.
void screen(SpanState& state, std::uint32_t column);

// In lines and cells: settles what can be settled of the column's undecided candidates; true when
// all are. Several passes settle all: the earliest undecided candidate never waits for another. In
// exact see darts.h.
bool admit(SpanState& state, std::uint32_t column);
bool admit(BitState& state, std::uint32_t column);

// In lines and cells: whether a sample that was taken out covers the candidate.
bool is_covered(const SpanState& state, const Candidate& candidate);
bool is_covered(const BitState& state, const Candidate& candidate);

// In lines and cells: into how many draws admit should look at first: all of the round's, or so
// many that they have few enough others within reach of them to be compared with each.
std::uint32_t first_part(const SpanState& state);
std::uint32_t first_part(const BitState& state);

// In exact: puts the column's samples of this round into the grid.
void insert(SpanState& state, std::uint32_t column);

// Cuts the round's chords from the column's lines. False when a line ran out of room: nothing is
// lost, and after grow() the same call completes the work.
bool subtract(SpanState& state, std::uint32_t column);
// Blocks the column's lattice points that fail the metric with a sample of the round.
void subtract(BitState& state, std::uint32_t column);

// Replaces the column's places by what all samples near them leave of them, `width` wide: its own
// places' width, or half of it.
void refine(SpanState& state, std::uint32_t column, std::uint32_t width);

}  // namespace lacuna::cpu
