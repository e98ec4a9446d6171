// Where several sets of polygons let samples lie: inside of any that is not forbidden, and outside
// of all that are.
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

    // How deep a place lies in the region: its distance to the edges of the set in which it lies
    // deepest, or to those of a forbidden set if they are nearer. Negative outside.
    double depth_of(Point place) const;

private:
    std::vector<Outline> allowed_;
    std::vector<Outline> forbidden_;
    bool is_everywhere_;  // no set says where samples may lie
};

}  // namespace lacuna::verify
