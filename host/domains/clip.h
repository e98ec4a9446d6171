// What both users of the library Clipper need: rings in whole numbers, and their union.
#pragma once

#include <lacuna/domain.h>

#include <clipper.hpp>
#include <limits>
#include <span>
#include <vector>

namespace lacuna::domains {

using ClipperLib::Path;
using ClipperLib::Paths;

// The power of two that turns coordinates into whole numbers of 52 bits. Clipper computes some of
// them in doubles, which hold 53.
int exponent_for(double largest);

double largest_of(std::span<const PolygonRing> rings);
Path whole_path(const PolygonRing& ring, int exponent);
PolygonRing ring_of(const Path& path, int exponent);

// The rings go around each place once that is inside of `paths` by the rule.
Paths united(const Paths& paths, ClipperLib::PolyFillType fill);

struct Box {
    Path::value_type low{std::numeric_limits<ClipperLib::cInt>::max(),
                         std::numeric_limits<ClipperLib::cInt>::max()};
    Path::value_type high{std::numeric_limits<ClipperLib::cInt>::min(),
                          std::numeric_limits<ClipperLib::cInt>::min()};

    void add(const Path& path);
    bool touches(const Box& other) const {
        return low.X <= other.high.X && other.low.X <= high.X && low.Y <= other.high.Y &&
               other.low.Y <= high.Y;
    }
};

}  // namespace lacuna::domains
