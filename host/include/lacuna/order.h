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

// The indices of the points in a progressive order: each once. The first are as far apart as points
// of about 16 can be, and the distance shrinks from level to level, by 2^(-1/32), as with
// Request::progressive: a level takes each point, in an order of chance, that is at least so far
// from all that were taken before. With a field, whose importance must not be 0 at a point, the
// distance of two points is counted in units of the smaller of their radii, 1 / sqrt(importance).
// The same on every machine. Takes O(n log n) time for points that are spread evenly.
// Throws BadRequest for a point outside the domain or on importance 0, and what sample() throws for
// a domain or a field.
std::vector<std::uint32_t> progressive_order(std::span<const Point> points, const Field* field,
                                             const OrderOptions& options);

}  // namespace lacuna
