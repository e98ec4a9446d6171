// The inner loops for x86 processors that have AVX2.
#pragma once

#include "backends/cpu/vectors.h"

namespace lacuna::cpu {

// Null on processors without it.
const Vectors* avx2_vectors();

}  // namespace lacuna::cpu
