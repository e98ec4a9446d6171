// A ground in words, as kernels read it (portable/ground.h), but for its radii, which are so
// already.
#pragma once

#include <cstdint>
#include <vector>

#include "plan/ground.h"

namespace lacuna::device {

struct GroundTables {
    std::vector<std::uint32_t> axes;
    std::vector<std::uint32_t> mask_bits;  // at least one word
};

GroundTables tables_of(const Ground& ground);

}  // namespace lacuna::device
