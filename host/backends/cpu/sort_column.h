// The order of a column's candidates, which admit and subtract rely on.
#pragma once

#include <cstdint>
#include <span>

#include "backends/backend.h"

namespace lacuna::cpu {

// Sorts by y, and by order where y is equal; every y is below `height`.
void sort_column(std::span<Candidate> candidates, std::uint32_t height);

}  // namespace lacuna::cpu
