// How work items divide the subtract of mode cells on a device. No call of a device in here.
#pragma once

#include <cstdint>
#include <vector>

#include "plan/plan.h"

namespace lacuna::device {

// The most turns that the loops of subtract_in_cells take for a sample with this reach: on one
// line, and on all lines near it.
std::uint64_t turns_of_line(const Plan& plan, std::uint32_t reach);
std::uint64_t turns_of_sample(const Plan& plan, std::uint32_t reach);

// The number of work items that divide the lines near such a sample, so that each takes at most
// `most` turns, unless a single line takes more.
std::uint32_t slices_of_sample(const Plan& plan, std::uint32_t reach, std::uint64_t most);

}  // namespace lacuna::device
