// Proves or refutes what a Poisson-disk set promises, from its coordinates alone, whoever made it.
//
// What is promised
//   - All is computed in double from the points given, by code that the samplers do not share.
//     Distances are what a user would compute, sqrt(dx * dx + dy * dy), around a torus' edges.
//   - Proof::kept is exact: no two points are closer than the radius, or `first` and `second` are.
//   - Proof::covered: no spot of the domain, edges and corners included, is farther than radius +
//     tolerance from every point, but for 1e-12 of the longer side; or `emptiest` is such a spot.
//   - The work grows nearly linearly with the points, however they are crowded.
#pragma once

#include <lacuna/lacuna.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <span>

namespace lacuna {

// What is said of a set.
struct Claim {
    double radius = 0;  // least distance between two points, > 0
    double width = 1;   // of the domain, as in Request
    double height = 1;
    Boundary boundary = Boundary::box;

    // How far over the radius a gap may be; unset: 2^-28 of the longer side, more than sample() may
    // lose by rounding the radius up.
    std::optional<double> tolerance;
    bool distances_only = false;  // gaps are not looked for, which takes most of the time
};

// What was found. Points are numbered from 0, in the order given.
struct Proof {
    // The first point outside the domain: a box has its far edges, a torus has not. If there is
    // one, nothing else was looked at.
    std::optional<std::size_t> outside;

    bool kept = false;
    std::size_t first = 0;  // the closest two points, where there are two
    std::size_t second = 0;
    double least_distance = 0;  // infinite for fewer than two points

    bool covered = false;
    Point emptiest{0, 0};  // the spot farthest from every point, if there is a point
    double emptiest_distance = 0;

    // Kept, covered, and with a tolerance of at most 1 % of the radius: a larger one would let a
    // set pass that lacks points.
    bool maximal = false;
};

// `keep_going`, if there is one, is asked often, by every thread that works; false ends the work.
// Throws BadRequest for a domain, radius or tolerance that makes no sense, Unavailable where the
// system makes no threads, and Cancelled.
Proof prove(std::span<const Point> points, const Claim& claim,
            const std::function<bool()>& keep_going = {});

}  // namespace lacuna
