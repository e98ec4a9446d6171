// Proves or refutes what a maximal Poisson-disk set promises, from its coordinates alone.
//
// Shares no code with the samplers, whose whole numbers it knows nothing of: everything is done in
// doubles on what the user reads back, with bounds for their rounding.
#pragma once

#include <lacuna/lacuna.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "verify/closest.h"
#include "verify/emptiest.h"
#include "verify/patience.h"

namespace lacuna::verify {

struct Verdict {
    // The first point that is not in the domain: a box with its far edges, a torus without. If any,
    // nothing else was looked at.
    std::optional<std::size_t> outside;
    Pair closest;
    Spot emptiest;
    bool kept = false;     // no two points are closer than the radius
    bool covered = false;  // no spot is farther than radius + tolerance from every point

    bool is_maximal() const { return kept && covered; }
};

// A gap wider by more than this share of the radius is no rounding: a point taken out of a maximal
// set leaves its own place at least a radius from every other point, in the mean 1.054 radii, so
// that with a tolerance of some 5 % a set with holes would pass for maximal.
inline constexpr double kMostTolerance = 0.01;

// Throws BadRequest("domain", ...) unless both sides lie between 1e-100 and 1e100 and neither is
// over 1000 times the other.
void check_domain(double width, double height);

// Throws BadRequest("tolerance", ...) unless it is finite and at least 0.
void check_tolerance(double tolerance);

// Of the longer side. Far above what doubles can tell apart, far below any set that fits a disk.
inline constexpr double kSmallestRadius = 0x1p-32;

// A value as it stands in a message.
std::string text(double value);

// More than samplers on a grid may lose: 2^-28 of the longer side. That is at least four units of a
// grid with 2^30 or more of them along that side; rounding the radius up to whole units takes up to
// two, and a spot between the grid's is up to sqrt(2) from one of them.
double default_tolerance(double width, double height);

// Distances wrap around the edges of a torus, and are what a user would compute: in double,
// sqrt(dx * dx + dy * dy). A point and its own image are not a pair.
//
// `kept` is exact. When `covered` is false, emptiest is a spot that is too far from every point;
// when true, no spot is, but for kFinest of the longer side.
// Throws BadRequest for a domain, radius or tolerance that makes no sense, and Cancelled.
Verdict check(std::span<const Point> points, double width, double height, bool torus, double radius,
              double tolerance, const Patience& patience = {});

// The same without a look for gaps: emptiest and covered stay as they are made.
Verdict check_distances(std::span<const Point> points, double width, double height, bool torus,
                        double radius, const Patience& patience = {});

}  // namespace lacuna::verify
