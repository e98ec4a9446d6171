// The points to keep of a claim that lie outside of its domain.
#pragma once

#include <lacuna/verify.h>

#include <cstddef>
#include <vector>

#include "verify/domain.h"

namespace lacuna::verify {

// Decides which kept points are no points of the set. Those outside of a box are not. If there are
// such points, those on its upper edges are not either: they belong to the sets beside it.
class Outside {
public:
    explicit Outside(const Claim& claim);
    bool has(Point kept) const;

private:
    Domain domain_;
    bool has_any_;
};

// Neighbours of a set: kept points outside of a box that may be too close to a point of the domain,
// or cover a spot of it.
struct Neighbours {
    std::vector<Point> points;
    std::vector<std::size_t> places;  // in Claim::keep
    double longer_side = 0;           // of the box around them and the domain
};
Neighbours neighbours_of(const Claim& claim);

}  // namespace lacuna::verify
