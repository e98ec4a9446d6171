// The two samples of a set that are closest for what they have to keep apart, where radii differ.
#pragma once

#include <lacuna/lacuna.h>

#include <cstddef>
#include <limits>
#include <span>

#include "verify/domain.h"
#include "verify/emptiest_by_limit.h"
#include "verify/patience.h"

namespace lacuna::verify {

// Two samples have to keep the smaller of their radii apart.
struct LimitedPair {
    std::size_t first = 0;  // less than `second`
    std::size_t second = 0;
    double distance = std::numeric_limits<double>::infinity();  // so for fewer than two samples
    double limit = 0;
    double ratio = std::numeric_limits<double>::infinity();  // distance / limit

    bool is_kept() const { return distance >= limit; }
};

// Shares of a limit below this are all as bad: of such pairs, the first that was met.
constexpr double kHopeless = 1e-6;

// The pair of the least ratio, and of several the one of lowest indices. All disks must lie in the
// domain. The work is nearly linear, however disks are crowded and whatever their radii.
LimitedPair closest_by_limit(const Domain& domain, std::span<const Disk> disks,
                             const Patience& patience = {});

}  // namespace lacuna::verify
