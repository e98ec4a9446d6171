// Numbers that must be finite, and on which side of 0, and the number of threads. Each check throws
// BadRequest.
#pragma once

#include <lacuna/errors.h>

#include <cmath>
#include <cstdint>
#include <string>

#include "base/number_text.h"
#include "base/threads.h"

namespace lacuna {

inline void check_positive(const char* option, double value) {
    if (!std::isfinite(value) || value <= 0)
        throw BadRequest(option, shortest(value), "must be a finite number greater than 0");
}

inline void check_at_least_0(const char* option, double value) {
    if (!std::isfinite(value) || value < 0)
        throw BadRequest(option, shortest(value), "must be a finite number of at least 0");
}

inline void check_threads(std::uint32_t threads) {
    if (threads > kMostThreads)
        throw BadRequest("threads", std::to_string(threads),
                         "must be at most " + std::to_string(kMostThreads));
}

}  // namespace lacuna
