// Bounds of how far the spots of a cell are over their limits, and which samples matter to them.
#pragma once

#include <lacuna/lacuna.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "verify/cell.h"
#include "verify/domain.h"
#include "verify/radius_field.h"

namespace lacuna::verify {

// How far the spots of a cell may be over their limits, as one sample sees them.
class Bounds {
public:
    Bounds(const Frame& frame, const Under& under)
        : frame_(frame), least_(under.radii.least), most_(under.radii.most) {}

    // With this sample's bound, no spot of the cell is over its limit by more than that. Lowers
    // `over` to the bound if the bound is lower, and only then takes a square root.
    void lower_to_most_over(const Disk& disk, double& over) const {
        const double sure = disk.limit_with(least_);
        const double farthest = frame_.to_farthest(disk.at);
        if (farthest < square(sure + over)) over = std::sqrt(farthest) - sure;
    }
    // Whether this sample's bound is at most `over`, which is at least 0.
    bool is_at_most(const Disk& disk, double over) const {
        return frame_.to_farthest(disk.at) <= square(disk.limit_with(least_) + over);
    }
    // Whether this sample may be the one that covers some spot of the cell best. It cannot be if
    // it leaves all spots over their limits by more than `over`, which is another sample's bound.
    bool may_matter(const Disk& disk, double over) const {
        return frame_.to_nearest(disk.at) <= square(effective(disk) + std::max(over, 0.0));
    }
    // The largest limit between the sample and a spot of the cell.
    double effective(const Disk& disk) const { return disk.limit_with(most_); }

private:
    const Frame frame_;
    double least_;
    double most_;
};

// Removes most of the samples from index `begin` to the end if they are a crowd far from the cell.
// A sample is of no use if another one has no smaller radius and factor, and is no farther from any
// of the four corners. Then that other sample is no farther from any spot of the cell. `before`:
// how many samples mattered to the larger cell that was cut. Samples are a crowd if there are many
// of them and cutting the cell has hardly reduced their number.
void thin_out(const Cell& cell, const Bounds& bounds, std::size_t before,
              std::vector<Disk>& samples, std::size_t begin);

}  // namespace lacuna::verify
