// Random123 refuses processors that it does not know, such as WebAssembly. Its Philox is portable
// C, so this header pretends that the processor is a RISC-V, which it knows but has no special code
// for.
#pragma once

// These headers must not see the macro __riscv.
#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>
#include <stdexcept>

#define __riscv 1
#include_next <Random123/philox.h>
#undef __riscv
