// Puts points that are there already into a progressive order: the first n, for any n, are spread
// as evenly as can be. Link lacuna.
#pragma once

#include <lacuna/export.h>
#include <lacuna/sample.h>

#include <cstdint>
#include <span>
#include <vector>

namespace LACUNA_API lacuna {

struct OrderOptions {
    Domain domain{};
    std::uint64_t seed = 0;  // decides the order of points that are equally good
};

// Returns the indices of all points in a progressive order, which has levels as the order of
// Request::progressive has: the first has a radius at which about 16 points fit, and each next one
// a radius smaller by 2^(-1/32). For a level, points are tried in a random order, and each is
// chosen that is at least the radius away from all points chosen before. With a field, the distance
// of two points is divided by the smaller of their 1 / sqrt(importance); the importance must not be
// 0 at a point. The result is the same on every machine. It takes O(n log n) time for points that
// are spread evenly; a CancelScope (lacuna/cancel.h) ends it early. Throws BadRequest for a point
// outside the domain or on importance 0, and what sample() throws for a domain or a field.
// It is not for dithering. The places of a lattice, such as the centres of all pixels, have few
// different distances: once some 36 % are chosen, each other one has a neighbour that is chosen,
// and all are equally good. The first half then has .6 of the power of white noise at low
// frequencies (docs/order.md).
std::vector<std::uint32_t> progressive_order(std::span<const Point> points, const Field* field,
                                             const OrderOptions& options);

}  // namespace lacuna
