// Random123 lists the processors that it was tried on, and WebAssembly is not among them. Its
// Philox is C without assumptions about the processor: here it is told of a processor of that list
// for which it has no code of its own.
#pragma once

// What Random123 includes must not see that name.
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
