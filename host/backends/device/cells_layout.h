// How the subtract of mode cells is shared out on a device. No call of a device in here.
#pragma once

#include <cstdint>
#include <vector>

#include "plan/plan.h"

namespace lacuna::device {

// Turns that the loops of subtract_in_cells take for one sample of such a reach, at most, of one
// line and of all that are near it.
std::uint64_t turns_of_line(const Plan& plan, std::uint32_t reach);
std::uint64_t turns_of_sample(const Plan& plan, std::uint32_t reach);

// Among how many work items the lines near such a sample are shared out, so that none takes more
// turns than `most` where a single line does not.
std::uint32_t slices_of_sample(const Plan& plan, std::uint32_t reach, std::uint64_t most);

}  // namespace lacuna::device
