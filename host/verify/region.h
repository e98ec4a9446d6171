// Where several sets of polygons let samples lie: inside of any that is not forbidden, outside of
// all that are, and near to any that samples must be near to.
#pragma once

#include <lacuna/lacuna.h>

#include <span>
#include <vector>

#include "verify/outline.h"

namespace lacuna::verify {

class Region {
public:
    explicit Region(std::span<const PolygonSet> sets);

    // Whether a cell has open places, which lie deeper in the region than `clearance`, and closed
    // places. As Outline::under(): near edges the answer may include a kind that there is not.
    Openness under(const Cell& cell, double clearance) const;

    // How deep a place lies in the region. It is the distance to the edges of the set in which the
    // place lies deepest. If the edges of a forbidden set are nearer, it is the distance to them.
    // Outside of the region it is negative.
    double depth_of(Point place) const;

private:
    struct Kept {
        Outline outline;
        double distance;  // that samples keep from it
    };
    std::vector<Kept> allowed_;  // none: samples may lie everywhere
    std::vector<Kept> forbidden_;
    std::vector<Kept> near_;  // none: samples may lie far from all
};

}  // namespace lacuna::verify
