// Random bits with AVX2 instructions.
#pragma once

#include "rounds/random_run.h"

namespace lacuna {

// Null if the processor has no AVX2.
const RandomRun* avx2_random_run();

}  // namespace lacuna
