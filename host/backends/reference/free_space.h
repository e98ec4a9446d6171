// The free spans of every line: f_{Y|X} of the paper's section 4.1, the bottom of its figure 1.
#pragma once

#include <cstdint>
#include <vector>

#include "backends/backend.h"
#include "plan/plan.h"

namespace lacuna::reference {

class FreeSpace {
public:
    explicit FreeSpace(const Plan& plan);

    // Total length of the line's free spans.
    std::uint32_t free_length(std::uint32_t line) const { return free_lengths_[line]; }
    // The rank-th free y of the line, counting from below. rank < free_length(line).
    std::uint32_t y_at_rank(std::uint32_t line, std::uint32_t rank) const;
    bool is_free(std::uint32_t line, std::uint32_t y) const;
    // Takes the sample's disk out of every line that crosses it.
    void subtract_disk(Sample sample);

    const std::vector<Span>& spans(std::uint32_t line) const { return spans_[line]; }

private:
    void subtract_chord(std::uint32_t line, std::int64_t begin, std::int64_t end);

    const Plan& plan_;
    std::vector<std::vector<Span>> spans_;  // of each line: sorted, disjoint, none empty
    std::vector<std::uint32_t> free_lengths_;
};

}  // namespace lacuna::reference
