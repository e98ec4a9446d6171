// Puts points that are there already into a progressive order: every first part of them is as even
// as can be. Link lacuna.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <span>
#include <vector>

namespace lacuna {

struct OrderOptions {
    double width = 1.0;  // of the domain, as in Request
    double height = 1.0;
    Boundary boundary = Boundary::box;
    std::uint64_t seed = 0;  // of the order in which points that are equally good come
};

// Returns the indices of all points in a progressive order, which has levels as the order of
// Request::progressive has: the first has a radius at which about 16 points fit, and each next one
// a radius smaller by 2^(-1/32). A level looks at the points in a random order, and takes each
// point that is at least the radius away from all points taken before. With a field, distances are
// in units of 1 / sqrt(importance), of the two points' the smaller; the importance must not be 0 at
// a point. The result is the same on every machine. It takes O(n log n) time for points that are
// spread evenly; a CancelScope (lacuna/cancel.h) ends it early. Throws BadRequest for a point
// outside the domain or on importance 0, and what sample() throws for a domain or a field.
// It is not for dithering. The places of a lattice, such as the centres of all pixels, have few
// different distances: once some 36 % are taken, each free one has a neighbour that is taken, and
// all are equally good. The first half then has .6 of the power of white noise at low frequencies
// (docs/order.md).
std::vector<std::uint32_t> progressive_order(std::span<const Point> points, const Field* field,
                                             const OrderOptions& options);

}  // namespace lacuna
