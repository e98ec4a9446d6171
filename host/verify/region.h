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
    // Outlines in a tree, so that an answer needs only those nearby.
    class Outlines {
    public:
        Outlines(std::span<const PolygonSet> sets, bool (*are_wanted)(Role role));

        bool are_none() const { return kept_.empty(); }
        // Calls use(outline, distance) for those within `clearance` of the cell, and for others.
        template <typename Use>
        void visit_near(const Cell& cell, double clearance, Use use) const;
        // The least of_one(outline, distance), which must be at least a place's distance from the
        // outline, less the distance that samples keep from it. Infinity without any outline.
        template <typename OfOne>
        double least(Point place, OfOne of_one) const;

    private:
        struct Kept {
            Outline outline;
            double distance;  // that samples keep from it
        };
        static std::vector<Kept> kept_of(std::span<const PolygonSet> sets,
                                         bool (*are_wanted)(Role role));

        std::vector<Kept> kept_;
        RectangleTree tree_;  // of rectangles that hold all places within the distance
    };
    Outlines allowed_;  // none: samples may lie everywhere
    Outlines forbidden_;
    Outlines near_;  // none: samples may lie far from all
};

}  // namespace lacuna::verify
