// Bounds of how far the spots of a cell are over their limits, and the disks that matter to them.
#pragma once

#include <lacuna/lacuna.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "verify/cell.h"
#include "verify/emptiest_by_limit.h"
#include "verify/ground.h"

namespace lacuna::verify {

// How far the spots of a cell may be over their limits, as one sample sees it.
class Bounds {
public:
    Bounds(const Frame& frame, const Under& under)
        : frame_(frame), least_(under.radii.least), most_(under.radii.most) {}

    // No spot is over by more than this.
    double most_over(const Disk& disk) const {
        return std::sqrt(frame_.to_farthest(disk.at)) - std::min(disk.radius, least_);
    }
    // Whether that is at most `over`, which is at least 0.
    bool is_at_most(const Disk& disk, double over) const {
        return frame_.to_farthest(disk.at) <= square(std::min(disk.radius, least_) + over);
    }
    // Whether some spot may be over by no more than this, so that the sample can matter to a cell
    // whose spots are over by no more in the eyes of another sample.
    bool may_matter(const Disk& disk, double over) const {
        return frame_.to_nearest(disk.at) <= square(effective(disk) + std::max(over, 0.0));
    }
    // How far the sample reaches in this cell at most.
    double effective(const Disk& disk) const { return std::min(disk.radius, most_); }

private:
    const Frame frame_;
    double least_;
    double most_;
};

// Drops most of the disks from `begin` on if they are a crowd far from the cell: one that is no
// nearer to any of the four corners than some other that reaches as far is of no use, as the spots
// that are nearer to one of two points are a half-plane. `before`: how many there were for the cell
// that this one is a part of; a crowd is hardly fewer.
void thin_out(const Cell& cell, const Bounds& bounds, std::size_t before, std::vector<Disk>& disks,
              std::size_t begin);

}  // namespace lacuna::verify
