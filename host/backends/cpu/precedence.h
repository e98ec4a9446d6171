// Which of two candidates of a round comes first.
#pragma once

#include "backends/backend.h"

namespace lacuna::cpu {

// By the order of their draws, wherever they lie: deciding in spatial order would favour one side
// and bias the set. tests/distribution builds that variant and shows that it is noticed.
inline bool precedes(const Candidate& a, const Candidate& b) {
    return a.order < b.order;
}

}  // namespace lacuna::cpu
