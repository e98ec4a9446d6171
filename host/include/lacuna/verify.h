// Proves or refutes what a Poisson-disk set promises, from its coordinates alone, whoever made it.
//
// What is promised
//   - All is computed in double from the points given, by code that the samplers do not share.
//     Distances are what a user would compute, sqrt(dx * dx + dy * dy), around a torus' edges.
//   - Proof::kept is exact: no two points are closer than the radius, or `first` and `second` are.
//   - Proof::covered: no spot of the domain, edges and corners included, is farther than radius +
//     tolerance from every point, but for 1e-12 of the longer side; or `emptiest` is such a spot.
//   - With a field each place has its pixel's radius, scale / sqrt(importance), and two places are
//     to be the smaller of theirs apart: that is the pair's limit, and it is how near a spot must
//     have a point. Where the importance is 0 no point may lie, and no spot need be covered.
//   - A mask, polygons and a border say where points may lie, as in Request; a spot where none may
//     need not be covered. The edges of polygons may be off by Claim::edge_tolerance: a point may
//     lie so far outside, and a spot that is no farther inside than that, and 4e-12 of the longer
//     side, need not be covered. A line that two rings share is an edge of both.
//   - Samplers round the borders of pixels to the lines of a grid. So a point within 2^-28 of the
//     longer side of a border may be on either pixel: the smaller radius holds for distances, the
//     larger for what it covers, and it may lie there if it may on either. By as much it may lie
//     beyond a border or the edges of polygons.
//   - Points to keep are the first of the set, in their order, and equal to the last bit.
//   - The work grows nearly linearly with the points, however they are crowded.
#pragma once

#include <lacuna/lacuna.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace lacuna {

// What is said of a set.
struct Claim {
    double radius = 0;  // least distance between two points, > 0; not looked at with a field
    double width = 1;   // of the domain, as in Request
    double height = 1;
    Boundary boundary = Boundary::box;

    // How far over the radius a gap may be; unset: 2^-28 of the longer side, more than sample() may
    // lose by rounding the radius up; twice that with a field, mask, polygons or border, whose
    // edges are rounded too.
    std::optional<double> tolerance;
    bool distances_only = false;  // gaps are not looked for, which takes most of the time

    // Radii that differ from place to place: the field, stretched over the domain, and the radius
    // where its importance is 1. It must outlive the call.
    const Field* field = nullptr;
    double scale = 0;  // > 0

    // Where points may lie, as in Request: pixels that are not 0; inside of polygons, by the
    // even-odd rule, where there are any; and so far from a box's edges. They must outlive the
    // call.
    const Mask* mask = nullptr;
    std::span<const std::vector<Point>> inside{};
    double edge_tolerance = 0;  // how far the polygons' edges may be off
    double border = 0;

    // What the points begin with, to the bit. It must outlive the call.
    std::span<const Point> keep{};
};

// What was found. Points are numbered from 0, in the order given.
struct Proof {
    // The first point outside the domain: a box has its far edges, a torus has not. If there is
    // one, nothing else was looked at.
    std::optional<std::size_t> outside;
    // The first point of Claim::keep that is not in its place. If there is one, nothing else was
    // looked at.
    std::optional<std::size_t> moved;
    // The first point that lies where no point may, and what says so. If there is one, nothing else
    // was looked at.
    enum class Closed { importance, mask, polygons, border };
    std::optional<std::size_t> forbidden;
    Closed forbidden_by = Closed::importance;

    // The closest two points, where there are two: with a field the two of the least distance for
    // their limit.
    bool kept = false;
    std::size_t first = 0;
    std::size_t second = 0;
    double least_distance = 0;  // infinite for fewer than two points
    double least_limit = 0;     // what the two have to keep: the radius, or the smaller of theirs

    // The spot farthest from every point, if there is a point: with a field the one that is
    // farthest over its limit, and where all are covered any.
    bool covered = false;
    Point emptiest{0, 0};
    double emptiest_distance = 0;  // with a field to the point that covers the spot best
    double emptiest_limit = 0;     // how near a point must be there: the radius, or the smaller one

    // Kept, covered, and with a tolerance of at most 1 % of the radius, with a field of its least
    // radius: a larger one would let a set pass that lacks points.
    bool maximal = false;
};

// `keep_going`, if there is one, is asked often, by every thread that works; false ends the work.
// Throws BadRequest for a domain, radius, tolerance, field, scale, mask, polygons or border that
// makes no sense, Unavailable where the system makes no threads, and Cancelled.
Proof prove(std::span<const Point> points, const Claim& claim,
            const std::function<bool()>& keep_going = {});

}  // namespace lacuna
