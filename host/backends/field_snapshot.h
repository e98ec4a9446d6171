// What a snapshot of mode exact with a radius field leaves out, because it follows from the plan.
// For restore() of all backends.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "backends/backend.h"
#include "plan/first_boxes.h"

namespace lacuna {

// The block of first boxes that a position lies in.
std::uint32_t block_at(const FirstBoxes& first, std::uint32_t x, std::uint32_t y);

// The radii of samples, some of which may be the plan's kept ones.
std::vector<Sized> with_radii(const Plan& plan, std::span<const Sample> samples);

// Sorts samples by x, then y, and drops all but one of those at the same position.
void sort_for_snapshot(std::vector<Sample>& samples);

}  // namespace lacuna
