// The marginal F_X (section 3, Eq. 1) as running sums of the lines' free lengths, and its
// inversion (Eq. 2), in constant time a draw by a guide table (Chen & Asau 1974). Sequential.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "backend.h"
#include "plan.h"

namespace lacuna {

class Marginal {
public:
    explicit Marginal(const Plan& plan);

    // New running sums, from the free length of every line.
    void rebuild(std::span<const std::uint32_t> free_lengths);

    // Total weight of the lines: their free length or, with uniform-x, how many have any.
    std::uint64_t total() const { return sums_.back(); }

    // Draws first_number, first_number + 1, ... of the plan's seed, `count` of them, inverted from
    // one cdf and sorted by line; those of one line stay in the order of their numbers.
    // Valid until the next call. total() must not be 0.
    std::span<const Draw> invert(std::uint64_t first_number, std::uint32_t count);

private:
    std::uint32_t line_at(std::uint64_t bits, std::uint64_t c) const;
    Draw draw(std::uint64_t number) const;
    void sort_by_line();

    const Plan& plan_;
    std::vector<std::uint64_t> sums_;     // sums_[line + 1]: all lines up to this one
    std::vector<std::uint32_t> lengths_;  // of every line; kept for uniform-x only
    std::vector<std::uint32_t> guide_;    // guide_[j]: the line at the start of the j-th part
    unsigned guide_bits_;                 // 0: rounds too small to pay for a guide
    std::vector<Draw> draws_;
    std::vector<Draw> sorted_;
    std::vector<std::uint32_t> starts_;  // of each line in sorted_
};

}  // namespace lacuna
