// The free spans of lines: in mode lines, and in exact until the first refinement.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "backends/backend.h"
#include "backends/cpu/round_memory.h"
#include "base/workers.h"
#include "plan/plan.h"

namespace lacuna::cpu {

class Lines {
public:
    explicit Lines(const Plan& plan);

    // The first line of each column, then the number of lines.
    const std::vector<std::uint32_t>& first_lines() const { return first_lines_; }
    // The line's spans: sorted, disjoint, none empty.
    std::span<const Span> spans_of(std::uint32_t line) const {
        return {slot(line), span_counts_[line]};
    }

    // Makes all of the column free.
    void set_free(std::uint32_t column);
    // Turns the column's draws into candidates.
    void locate(std::span<const Draw> draws, std::uint32_t column, RoundMemory& round) const;
    // Cuts the chords of the round's samples, and updates the lines' free lengths.
    void subtract(const RoundMemory& round, Workers& workers,
                  std::vector<std::uint32_t>& free_lengths);

    void snapshot(Snapshot& snapshot) const;
    // Returns the lines' free lengths.
    std::vector<std::uint32_t> restore(const Snapshot& snapshot);

private:
    Span* slot(std::uint32_t line) const { return &spans_[std::size_t{line} * capacity_]; }
    // Sets the line's spans, for which there must be room.
    void set_spans(std::uint32_t line, std::span<const Span> of_line);
    void make_room(std::uint32_t capacity);
    // Doubles the room of every line.
    void grow();
    // False when a line ran out of room: nothing is lost, and after grow() the same call completes
    // the work.
    bool subtract(const RoundMemory& round, std::uint32_t column,
                  std::vector<std::uint32_t>& free_lengths);

    const Plan& plan_;
    std::vector<std::uint32_t> first_lines_;
    std::uint32_t capacity_ = 0;  // the number of spans that a line has room for
    std::unique_ptr<Span[]> spans_;
    std::vector<std::uint32_t> span_counts_;
};

}  // namespace lacuna::cpu
