// The biased variant: the candidate further down comes first. The test that must notice it finds
// this file before host/backends/cpu/precedence.h on its include path.
#pragma once

#include <cstdint>
#include <span>

#include "backends/backend.h"

namespace lacuna::cpu {

inline bool precedes(const Candidate& a, const Candidate& b) {
    return a.home != b.home ? a.home < b.home : a.y < b.y;
}

// Candidates are numbered column by column, line by line.
inline std::uint32_t candidate_of_turn(std::span<const std::uint32_t>, std::uint32_t turn) {
    return turn;
}

inline std::uint32_t turn_of(const Candidate&, std::uint32_t i) {
    return i;
}

}  // namespace lacuna::cpu
