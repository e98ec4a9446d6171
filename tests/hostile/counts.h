// What hostile counts, and how it ends at the first fault.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <stdexcept>
#include <string>

#include "judge/plane.h"

namespace lacuna::tests {

struct Counts {
    std::uint64_t requests = 0, refusals = 0;
    std::uint64_t sets = 0, points = 0, comparisons = 0, proofs = 0;
    std::uint64_t refuted = 0;  // with one point less, moved or too close
    std::uint64_t as_good = 0;  // with such a change, because others cover the room
    std::uint64_t filled = 0;   // by gaps
};

inline void demand(bool is_so, const std::string& otherwise) {
    if (!is_so) throw std::runtime_error(otherwise);
}

inline std::string told(Point at) {
    return judge::text_of(at);
}

}  // namespace lacuna::tests
