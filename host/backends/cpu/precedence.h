// Which of two candidates of a round comes first.
#pragma once

#include <cstdint>
#include <span>

#include "backends/backend.h"

namespace lacuna::cpu {

// Precedence is the draw's number: spatial order would favour one side and bias the set.
// tests/distribution builds that variant and shows that it is noticed.
inline bool precedes(const Candidate& a, const Candidate& b) {
    return a.order < b.order;
}

// In exact, where draws are thrown one after another: the candidate whose turn it is.
inline std::uint32_t candidate_of_turn(std::span<const std::uint32_t> by_order,
                                       std::uint32_t turn) {
    return by_order[turn];
}

// The turn of candidate i.
inline std::uint32_t turn_of(const Candidate& candidate, std::uint32_t) {
    return candidate.order;
}

}  // namespace lacuna::cpu
