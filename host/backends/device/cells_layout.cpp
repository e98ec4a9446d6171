// The slices of subtract in mode cells.
#include "backends/device/cells_layout.h"

#include <algorithm>

namespace lacuna::device {

std::uint64_t turns_of_line(const Plan& plan, std::uint32_t reach) {
    // Two turns for each run of points under one pixel and one for each word; others for roots.
    constexpr std::uint64_t kOthers = 16;
    const std::uint64_t points = std::min(2 * std::uint64_t{reach} + 1, std::uint64_t{plan.height});
    const std::uint64_t pixels = points * plan.cells().radii->rows / plan.height + 2;
    return 2 * std::min(points, pixels) + points / 32 + kOthers;
}

std::uint64_t turns_of_sample(const Plan& plan, std::uint32_t reach) {
    const std::uint64_t lines = std::min(2 * std::uint64_t{reach} + 1, std::uint64_t{plan.lines});
    return lines * turns_of_line(plan, reach);
}

std::uint32_t slices_of_sample(const Plan& plan, std::uint32_t reach, std::uint64_t most) {
    const std::uint64_t lines = std::min(2 * std::uint64_t{reach} + 1, std::uint64_t{plan.lines});
    const std::uint64_t lines_of_slice =
        std::max<std::uint64_t>(most / turns_of_line(plan, reach), 1);
    return static_cast<std::uint32_t>((lines + lines_of_slice - 1) / lines_of_slice);
}

}  // namespace lacuna::device
