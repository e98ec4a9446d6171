// Sorts sites by a number of 64 bits, with leave to stop.
#pragma once

#include <cstdint>
#include <vector>

#include "base/polling.h"

namespace lacuna::relaxing {

struct Ranked {
    std::uint64_t rank;
    std::uint32_t index;
};

// By rank; what has equal ranks stays in the order given.
void sort_by_rank(std::vector<Ranked>& all, const Poll& poll);

}  // namespace lacuna::relaxing
