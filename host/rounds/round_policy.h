// The number of draws in a round, and in exact when to refine. Both are whole-number functions of
// the counts alone, so that every backend takes the same rounds.
#pragma once

#include <cstdint>

#include "plan/plan.h"

namespace lacuna {

// Smallest round of automatic size: with fewer draws the fixed cost of a round would prevail.
inline constexpr std::uint64_t kSmallestRound = 16;
// Largest rounds of automatic size. The largest array of a round has 24 bytes a draw
// (device/layout.cpp). With 2^22 draws it has 96 MiB, which fit into the 128 MiB that every Vulkan
// driver lets a kernel bind. In exact that limit would not help: there the arrays of boxes exceed
// 128 MiB before rounds reach 2^25 draws.
inline constexpr std::uint64_t kLargestRoundInLines = std::uint64_t{1} << 22;
inline constexpr std::uint64_t kLargestRoundInExact = std::uint64_t{1} << 25;

// On an empty domain A / (8 r^2) draws: about a sixth of the maximal count. About four in five of
// them are admitted.
std::uint64_t first_round_size(const Plan& plan);

// The limit for rounds of automatic size.
std::uint64_t largest_round_size(const Plan& plan);

class RoundPolicy {
public:
    // With a radius field, and in space, the first round has boxes already.
    explicit RoundPolicy(const Plan& plan)
        : plan_(plan), size_(first_round_size(plan)), refines_(plan.begins_with_boxes()) {}

    // Number of draws of the next round.
    std::uint64_t size() const { return size_; }
    // Whether the next round ends with refine instead of subtract; once true it stays true.
    bool refines() const { return refines_; }
    // Whether that refine halves the boxes.
    bool halves() const { return halves_; }

    // Records the result of a round of size() draws: `survivors` were free of earlier rounds'
    // samples, `admitted` of these became samples; then there are `bins` bins of width bin_width.
    void note(std::uint64_t survivors, std::uint64_t admitted, std::uint64_t bins,
              std::uint32_t bin_width);

private:
    void judge_bins(std::uint64_t survivors, std::uint32_t width);
    void note_in_space(std::uint64_t survivors, std::uint64_t admitted, std::uint64_t bins);

    const Plan& plan_;
    std::uint64_t size_;
    std::uint64_t seen_ = 0;  // draws since the bins were last judged
    std::uint64_t seen_survivors_ = 0;
    bool refines_;
    bool halves_ = false;
};

}  // namespace lacuna
