// What hostile counts, and how it ends at the first fault.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <string>

namespace lacuna::tests {

struct Counts {
    std::uint64_t sets = 0, points = 0, comparisons = 0, proofs = 0;
    std::uint64_t refuted = 0;  // with one point less or too close
    std::uint64_t as_good = 0;  // without one point, because others cover its room
};

inline void demand(bool is_so, const std::string& otherwise) {
    if (!is_so) throw std::runtime_error(otherwise);
}

inline std::string told(Point at) {
    std::ostringstream out;
    out.precision(17);
    out << "(" << at.x << ", " << at.y << ")";
    return out.str();
}

}  // namespace lacuna::tests
