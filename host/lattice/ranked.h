// Sorts sites by a 64-bit number; the sort can be cancelled.
#pragma once

#include <cstdint>
#include <vector>

#include "base/polling.h"

namespace lacuna::relaxing {

struct Ranked {
    std::uint64_t rank;
    std::uint32_t index;
};

// Sorts by rank; elements of equal rank keep their order.
void sort_by_rank(std::vector<Ranked>& all, const Poll& poll);

}  // namespace lacuna::relaxing
