// The spot that is farthest over what it may be from a sample, where radii differ from place to
// place.
#pragma once

#include <lacuna/lacuna.h>

#include <limits>
#include <span>

#include "verify/ground.h"
#include "verify/patience.h"

namespace lacuna::verify {

// A sample, and how far it reaches.
struct Disk {
    Point at;
    double radius;
};

// A spot is covered by a sample that is nearer than its limit: the smaller radius of the two.
struct BareSpot {
    Point at{0, 0};
    // Its own: that of the cell in which it was looked at. A spot in the middle of a cell that is a
    // rounding wide may lie on its side, which is the next pixel's.
    double radius = 0;
    // To the sample that leaves it the least over the limit, if there is any.
    double distance = std::numeric_limits<double>::infinity();
    double limit = 0;
    double over = -std::numeric_limits<double>::infinity();  // so if no sample may lie anywhere
};

// Among the spots where samples may lie, the one that is farthest over its limit. What is sure:
//   - when it is over by more than `tolerance`, no spot is over by more than it is, but for
//     kSpotPrecision of that and kFinest of the longer side;
//   - else no spot is over by more than `tolerance`, but for kFinest of the longer side.
// All disks must lie in the domain.
BareSpot emptiest_by_limit(const Ground& ground, std::span<const Disk> disks, double tolerance,
                           const Patience& patience = {});

}  // namespace lacuna::verify
