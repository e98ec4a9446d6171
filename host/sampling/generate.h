// The loop: rounds of draws until the free space is empty (docs/design.md, section 3).
#pragma once

#include <lacuna/lacuna.h>
#include <vector>

#include "backends/backend.h"
#include "plan/plan.h"

namespace lacuna {

struct Outcome {
    std::vector<Sample> samples;  // in order of admission
    std::uint64_t rounds = 0;
    std::uint64_t draws = 0;
    std::vector<std::uint64_t> numbers;  // of each sample's draw; the reference alone fills them in
};

// Makes a maximal set, or its first plan.limit samples. Throws Cancelled, DeviceError.
Outcome generate(const Plan& plan, Backend& backend, Observer& observer);

}  // namespace lacuna
