// Failing together: what one rank cannot do, none goes on with.
#pragma once

#include <array>
#include <cstdint>
#include <exception>

#include "ranks/ranks.h"

namespace lacuna {

// Thrown by all ranks at once. `own` is what this one has thrown, or none: another has.
struct FailedTogether {
    std::exception_ptr own;
};

// Calls work() on every rank, which may not call the others, and throws FailedTogether on all of
// them where it throws on one.
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
