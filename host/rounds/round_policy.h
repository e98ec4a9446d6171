// How many draws a round takes, and in exact when to refine: whole numbers only, a function of
// nothing but the counts so far, so that every backend takes the same rounds.
#pragma once

#include <cstdint>

#include "plan/plan.h"

namespace lacuna {

// Rounds of automatic size have at least kSmallestRound draws: with fewer, what a round costs apart
// from its draws would be most of its cost.
inline constexpr std::uint64_t kSmallestRound = 16;
// The largest array of a round has 24 bytes a draw (device/layout.cpp): with kLargestRoundInLines
// draws, the most in lines and in cells, 96 MiB, which fit into the 128 MiB that every Vulkan
// driver lets a kernel bind. In exact that would not help, because the arrays of boxes grow past
// 128 MiB in sets whose rounds are still smaller than kLargestRoundInExact.
inline constexpr std::uint64_t kLargestRoundInLines = std::uint64_t{1} << 22;
inline constexpr std::uint64_t kLargestRoundInExact = std::uint64_t{1} << 25;

// On an empty domain A / (8 r^2) draws: about a sixth of the maximal count, of which some four in
// five are admitted.
std::uint64_t first_round_size(const Plan& plan);

// What rounds of automatic size do not exceed.
std::uint64_t largest_round_size(const Plan& plan);

class RoundPolicy {
public:
    // A radius field begins with boxes.
    explicit RoundPolicy(const Plan& plan)
        : plan_(plan), size_(first_round_size(plan)), refines_(plan.radius_field != nullptr) {}

    // Draws of the next round.
    std::uint64_t size() const { return size_; }
    // Whether the next round ends in refine, not in subtract; once true it stays so.
    bool refines() const { return refines_; }
    // Whether that refine halves the places.
    bool halves() const { return halves_; }

    // What became of a round of size() draws: how many were free of earlier rounds' samples, how
    // many of those were admitted, and how many places there are after it, and how wide.
    void note(std::uint64_t survivors, std::uint64_t admitted, std::uint64_t places,
              std::uint32_t bin_width);

private:
    void judge_places(std::uint64_t survivors, std::uint32_t width);

    const Plan& plan_;
    std::uint64_t size_;
    std::uint64_t seen_ = 0;  // draws since the places were last judged
    std::uint64_t seen_survivors_ = 0;
    bool refines_;
    bool halves_ = false;
};

}  // namespace lacuna
