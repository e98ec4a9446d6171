// How many draws a round takes: whole numbers only, a function of nothing but the counts so far,
// so that every backend takes the same rounds.
#pragma once

#include <algorithm>
#include <cstdint>

#include "plan.h"

namespace lacuna {

inline constexpr std::uint64_t kSmallestRound = 16;
// A round's arrays stay within the 128 MiB that every Vulkan driver can bind.
inline constexpr std::uint64_t kLargestRound = std::uint64_t{1} << 22;

// On an empty domain A / (8 r^2) draws: about a sixth of the maximal count, of which some four in
// five are admitted.
inline std::uint64_t first_round_size(const Plan& plan) {
    if (plan.round_size != 0) return plan.round_size;
    const std::uint64_t area = std::uint64_t{plan.width} * plan.height;
    return std::clamp(area / plan.radius_squared / 8, kSmallestRound, kLargestRound);
}

// Steers towards four in five: grow while more are admitted, shrink while fewer are.
inline std::uint64_t next_round_size(const Plan& plan, std::uint64_t size, std::uint64_t admitted) {
    if (plan.round_size != 0) return plan.round_size;
    const std::uint64_t lost = size - admitted;
    // The share lost grows with the size of the round: size / 5 lost is where it should be.
    const std::uint64_t wanted = lost == 0 ? 2 * size : size * size / (5 * lost);
    return std::clamp(std::clamp(wanted, size / 2, 2 * size), kSmallestRound, kLargestRound);
}

}  // namespace lacuna
