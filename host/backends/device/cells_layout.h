// How a plan of mode cells is laid out on a device: the lattice's bits, and the slices of subtract.
// No call of a device in here.
#pragma once

#include <cstdint>
#include <vector>

#include "plan/plan.h"

namespace lacuna::device {

// Of 32 bits, as in Snapshot::bits.
std::uint32_t words_per_line(const Plan& plan);

// The words of the lines [first_line, end_line) before the first sample: a bit for each lattice
// point, set where there is importance.
std::vector<std::uint32_t> first_bits(const Plan& plan, std::uint32_t first_line,
                                      std::uint32_t end_line);

// Turns that the loops of subtract_in_cells take for one sample of such a reach, at most, of one
// line and of all that are near it.
std::uint64_t turns_of_line(const Plan& plan, std::uint32_t reach);
std::uint64_t turns_of_sample(const Plan& plan, std::uint32_t reach);

// Among how many work items the lines near a sample are shared out, so that none takes more turns
// than `most` where a single line does not.
std::uint32_t slices_of_sample(const Plan& plan, std::uint64_t most);

}  // namespace lacuna::device
