// Bounds of how far the spots of a cell are over their limits, and which samples matter to them.
#pragma once

#include <lacuna/lacuna.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "verify/cell.h"
#include "verify/domain.h"
#include "verify/radius_field.h"

namespace lacuna::verify {

// How far the spots of a cell may be over their limits, as one sample sees them. For ellipses see
// ellipse_bounds.h.
template <typename Sample>
class Bounds;

template <>
class Bounds<Disk> {
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

    // What thin_out compares: the squared distances from a sample to the corners of the cell. If
    // one sample is nearer to all four corners than another, then it is nearer to all spots.
    static constexpr bool can_thin_out() { return true; }
    std::array<double, 4> to_corners(const Cell& cell, const Disk& disk) const {
        const double left = square(disk.at.x - cell.left);
        const double right = square(disk.at.x - cell.right);
        const double bottom = square(disk.at.y - cell.bottom);
        const double top = square(disk.at.y - cell.top);
        return {left + bottom, right + bottom, left + top, right + top};
    }
    // What the samples that thin_out compares all others with are the least in: at each corner the
    // distance, and how far the corner is over its limit.
    std::array<double, 8> scores(const std::array<double, 4>& squares, const Disk& disk) const {
        std::array<double, 8> scores;
        for (std::size_t k = 0; k < 4; ++k) {
            scores[k] = std::sqrt(squares[k]);
            scores[k + 4] = scores[k] - effective(disk);
        }
        return scores;
    }
    // Whether the other sample covers at least as much as this one, if it is no farther away.
    bool covers_as_much(const Disk& other, const Disk& disk) const {
        return effective(other) >= effective(disk) && other.factor >= disk.factor;
    }

private:
    const Frame frame_;
    double least_;
    double most_;
};

// Removes most of the samples from index `begin` to the end if they are a crowd far from the cell.
// A sample is of no use if another one has no smaller radius and factor, or the same ellipse, and
// is no farther from any of the four corners. Then that other sample is no farther from any spot of
// the cell. `before`: how many samples mattered to the larger cell that was cut. Samples are a
// crowd if there are many of them and cutting the cell has hardly reduced their number.
template <typename Sample>
void thin_out(const Cell& cell, const Bounds<Sample>& bounds, std::size_t before,
              std::vector<Sample>& samples, std::size_t begin);

}  // namespace lacuna::verify
