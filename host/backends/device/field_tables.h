// A radius field in words, as kernels read it (portable/radius_field.h). Its radii are words
// already and not in here.
#pragma once

#include <cstdint>
#include <vector>

#include "plan/radius_field.h"

namespace lacuna::device {

struct FieldTables {
    std::vector<std::uint32_t> axes;
    std::vector<std::uint32_t> mask_nodes;  // NODE_WORDS each; without a mask one word
    std::vector<std::uint32_t> ellipses;    // four words for each pixel; without ellipses four
};

FieldTables tables_of(const RadiusField& radius_field);

}  // namespace lacuna::device
