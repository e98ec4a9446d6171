// The biased variant: the candidate further down comes first. Found before host/cpu/precedence.h
// on the include path of the test that must notice it.
#pragma once

#include "backends/backend.h"

namespace lacuna::cpu {

inline bool precedes(const Candidate& a, const Candidate& b) {
    return a.line != b.line ? a.line < b.line : a.y < b.y;
}

}  // namespace lacuna::cpu
