// Failing together: if one rank fails at something, all ranks stop there.
#pragma once

#include <array>
#include <cstdint>
#include <exception>

#include "ranks/ranks.h"

namespace lacuna {

// Thrown by all ranks at once. `own` is this rank's exception; null if only other ranks failed.
struct FailedTogether {
    std::exception_ptr own;
};

// Calls work() on every rank. work() must not call other ranks. If it throws on one rank, all ranks
// throw FailedTogether.
template <typename Work>
void together(Ranks& ranks, Work work) {
    std::exception_ptr own;
    try {
        work();
    } catch (...) {
        own = std::current_exception();
    }
    std::array<std::uint64_t, 1> failed{own ? std::uint64_t{1} : 0};
    ranks.sum(failed);
    if (failed.front() > 0) throw FailedTogether{own};
}

}  // namespace lacuna
