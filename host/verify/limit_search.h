// One thread's part of the search for the barest spot: bounds of how far a cell's spots are over
// their limits, and the cutting by them.
#pragma once

#include <lacuna/lacuna.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "verify/cell.h"
#include "verify/emptiest_by_limit.h"
#include "verify/ground.h"
#include "verify/patience.h"

namespace lacuna::verify {

// What is asked of all spots.
struct Limits {
    const Ground& ground;
    double tolerance;  // so far over its limit a spot is as good as covered
    double finest;     // what is barer by less is not worth looking for
    double rounding;   // the most by which a distance may be off
    const Patience& patience;
};

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

class LimitSearch {
public:
    explicit LimitSearch(const Limits& limits) : limits_(limits) {}

    // The barest spot of the cell that was looked at; see emptiest_by_limit.
    BareSpot run(const Cell& cell, const Under& under, std::vector<Disk> disks);

private:
    // The disks that matter to the cell are on the stack from `begin` on.
    void visit(const Cell& cell, const Under& outer, std::size_t begin);
    // Sees whether the cell's centre is barer than the barest. The index of the disk that covers it
    // best.
    std::size_t look_from(Point centre, const Under& under, std::size_t begin);
    // Drops most disks of a cell that is far from a crowd; see Search::thin_out. Only disks that
    // reach as far can stand for others.
    void thin_out(const Cell& cell, const Bounds& bounds, std::size_t begin);
    // A cell of which no spot is farther over its limit needs no cutting.
    double settled_from() const;

    const Limits& limits_;
    BareSpot barest_;
    std::uint32_t visits_ = 0;
    std::vector<Disk> stack_;  // the disks of each cell from the first to the one visited
};

}  // namespace lacuna::verify
