// How a failing test prints the values that differ.
#pragma once

#include <ostream>

#include "backends/backend.h"

namespace lacuna {

inline std::ostream& operator<<(std::ostream& out, const Span& span) {
    return out << span.begin << ".." << span.end;
}
inline std::ostream& operator<<(std::ostream& out, const Sample& s) {
    return out << "(" << s.x << ", " << s.y << ")";
}
inline std::ostream& operator<<(std::ostream& out, const Box& box) {
    return out << box.x << "+" << box.width << ": " << box.begin << ".." << box.end;
}
inline std::ostream& operator<<(std::ostream& out, const Candidate& c) {
    return out << "(" << c.x << ", " << c.y << "), home " << c.home << ", draw " << c.order;
}

}  // namespace lacuna
