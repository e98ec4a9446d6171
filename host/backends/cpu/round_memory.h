// The candidates of a round on the cpu, column by column.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "backends/backend.h"
#include "backends/columns.h"
#include "plan/plan.h"
#include "portable/status.h"

namespace lacuna::cpu {

// The order of candidates within a column of a snapshot.
inline bool comes_before(const Candidate& a, const Candidate& b) {
    return a.y < b.y || (a.y == b.y && a.order < b.order);
}

// A column is a unit of work for threads: a run of lines or, with a radius field, a region of first
// boxes (plan/first_boxes.h).
struct RoundMemory {
    RoundMemory(const Plan& the_plan, std::uint32_t the_columns)
        : plan(the_plan), columns(the_columns), column_begins(columns + std::size_t{1}) {}

    const Plan& plan;
    std::uint32_t columns;                     // the number of columns
    std::vector<std::uint32_t> column_begins;  // the first candidate of each column, then the end
    std::vector<Candidate> candidates;
    std::vector<std::uint32_t> statuses;  // of each candidate, see portable/status.h
    std::vector<std::uint32_t> by_order;  // the candidate of each draw

    std::uint32_t count() const { return static_cast<std::uint32_t>(candidates.size()); }
    std::span<const Candidate> candidates_of(std::uint32_t column) const {
        return {candidates.data() + column_begins[column],
                column_begins[column + 1] - column_begins[column]};
    }
    void make_room(std::size_t size) {
        candidates.resize(size);
        statuses.resize(size);
    }
    // Makes room for the draws' candidates, and finds where those of each column begin.
    void begin(std::span<const Draw> draws, std::span<const std::uint32_t> bin_begins) {
        make_room(draws.size());
        by_order.resize(draws.size());
        find_column_begins(bin_begins, draws, column_begins);
    }
    // Finds the y of each draw by walking its rank along the line's free length. `pieces` are those
    // of the free length: spans, or words of bits. A line is walked once for all its draws, which
    // ascend in rank.
    template <typename Pieces>
    void locate_on_lines(std::span<const Draw> draws, std::uint32_t column, Pieces pieces) {
        const std::uint32_t begin = column_begins[column];
        const std::uint32_t end = column_begins[column + 1];
        decltype(pieces.first_of(0)) piece = nullptr;
        std::uint32_t passed = 0;
        std::uint32_t length = 0;
        for (std::uint32_t i = begin; i < end; ++i) {
            const std::uint32_t line = draws[i].bin;
            if (i == begin || line != draws[i - 1].bin) {
                piece = pieces.first_of(line);
                length = pieces.length(piece);
                passed = 0;
            }
            while (draws[i].rank - passed >= length) {
                passed += length;
                length = pieces.length(++piece);
            }
            candidates[i] = {line * plan.strip_width + draws[i].offset,
                             pieces.y_at(line, piece, draws[i].rank - passed), line,
                             draws[i].order};
        }
    }
    void set_undecided(std::uint32_t column) {
        std::fill(statuses.begin() + column_begins[column],
                  statuses.begin() + column_begins[column + 1], STATUS_UNDECIDED);
    }
    // Enters the column's candidates into by_order.
    void find_orders(std::uint32_t column) {
        for (std::uint32_t i = column_begins[column]; i < column_begins[column + 1]; ++i)
            by_order[candidates[i].order] = i;
    }
    // The candidates and their statuses, column by column, sorted by y.
    Snapshot snapshot() const {
        std::vector<std::uint32_t> sorted(count());
        std::iota(sorted.begin(), sorted.end(), 0u);
        for (std::uint32_t column = 0; column < columns; ++column)
            std::sort(sorted.begin() + column_begins[column],
                      sorted.begin() + column_begins[column + 1],
                      [&](std::uint32_t a, std::uint32_t b) {
                          return comes_before(candidates[a], candidates[b]);
                      });
        Snapshot snapshot;
        for (const std::uint32_t i : sorted) {
            snapshot.candidates.push_back(candidates[i]);
            snapshot.statuses.push_back(statuses[i]);
        }
        return snapshot;
    }
    // Begins a round with the snapshot's candidates, in the snapshot's order within each column.
    // locate(candidate) sets its `line` and returns its column.
    template <typename Locate>
    void restore(const Snapshot& snapshot, Locate locate) {
        std::vector<std::vector<std::uint32_t>> of_columns(columns);
        std::vector<Candidate> all = snapshot.candidates;
        for (std::uint32_t i = 0; i < all.size(); ++i) of_columns[locate(all[i])].push_back(i);
        candidates.clear();
        statuses.clear();
        by_order.resize(all.size());
        for (std::uint32_t column = 0; column < columns; ++column) {
            for (const std::uint32_t i : of_columns[column]) {
                candidates.push_back(all[i]);
                statuses.push_back(snapshot.statuses[i]);
            }
            column_begins[column + 1] = count();
            find_orders(column);
        }
    }
};

}  // namespace lacuna::cpu
