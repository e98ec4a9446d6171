// The inner loop of the Gaussian energy for x86 processors that have AVX2.
#pragma once

#include "relax/cpu/pulls.h"

namespace lacuna::relaxing::cpu {

// Null on processors without it.
const Puller* avx2_puller();

}  // namespace lacuna::relaxing::cpu
