// Random bits in the words of AVX2.
#pragma once

#include "rounds/random_run.h"

namespace lacuna {

// Null where the processor has no AVX2.
const RandomRun* avx2_random_run();

}  // namespace lacuna
