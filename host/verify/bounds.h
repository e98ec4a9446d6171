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

    // Lowers `over` to this sample's bound, if that is lower: no spot of the cell is over its limit
    // by more. A square root is only taken when it is.
    void lower_to_most_over(const Disk& disk, double& over) const {
        const double sure = std::min(disk.radius, least_);
        const double farthest = frame_.to_farthest(disk.at);
        if (farthest < square(sure + over)) over = std::sqrt(farthest) - sure;
    }
    // Whether that bound is at most `over`, which is at least 0.
    bool is_at_most(const Disk& disk, double over) const {
        return frame_.to_farthest(disk.at) <= square(std::min(disk.radius, least_) + over);
    }
    // Whether some spot of the cell may be over its limit by no more than `over`, as this sample
    // sees it. If another sample has the bound `over`, no other samples matter to the cell.
    bool may_matter(const Disk& disk, double over) const {
        return frame_.to_nearest(disk.at) <= square(effective(disk) + std::max(over, 0.0));
    }
    // The largest limit between the sample and a spot of the cell.
    double effective(const Disk& disk) const { return std::min(disk.radius, most_); }

private:
    const Frame frame_;
    double least_;
    double most_;
};

// Removes most of the samples from index `begin` to the end if they are a crowd far from the cell.
// A sample is of no use if another one is no farther from any of the four corners and has no
// smaller radius, because the spots that are nearer to one of two points are a half-plane.
// `before`: how many samples there were for the cell of which this one is a part. If their number
// hardly falls, they are a crowd.
void thin_out(const Cell& cell, const Bounds& bounds, std::size_t before,
              std::vector<Disk>& samples, std::size_t begin);

}  // namespace lacuna::verify
