// Polygons, as a proof needs them: how far a place is from their edges, and on which side.
#pragma once

#include <lacuna/lacuna.h>

#include <cstddef>
#include <span>
#include <vector>

#include "verify/cell.h"
#include "verify/pixels.h"
#include "verify/rectangle_tree.h"

namespace lacuna::verify {

enum class Side { inside, outside };

// Rings with their edges in a tree of rectangles. An edge that two rings share is an edge of both.
class Outline {
public:
    // A ring is a list of points, the last of which is joined to the first.
    explicit Outline(std::span<const std::vector<Point>> rings);

    bool is_empty() const { return edges_.empty(); }
    // Around all edges; not of an empty outline.
    const Cell& around() const { return tree_.around(); }

    // Whether a cell has open places, which lie deeper inside than `clearance`, and closed places,
    // which do not. `clearance` is positive. For a cell near edges, the answer may include a kind
    // of places that it does not have. But a cell that edges only touch is always found to be
    // closed. Otherwise a search would cut cells along an edge without end.
    // With Side::outside, open places lie deeper outside than the clearance.
    Openness under(const Cell& cell, double clearance, Side side = Side::inside) const;

    // The same for open places that lie nearer than `distance` to some edge, on either side.
    Openness within(const Cell& cell, double distance) const;

    // Distance to the nearest edge. It is positive inside, where an odd number of rings goes around
    // the place, and negative outside. Without any ring it is -infinity.
    double depth_of(Point place) const;

private:
    struct Edge {
        Point from;
        Point to;
    };
    static std::vector<Edge> edges_of(std::span<const std::vector<Point>> rings);
    static Cell around_edge(const Edge& edge);
    static double squared_distance(Point place, const Edge& edge);
    double nearest(Point place) const;
    bool is_inside(Point place) const;
    // The squared distance from the cell to the nearest edge.
    double least_squared_distance(const Cell& cell) const;
    // For each edge, take the place of the cell that is farthest from it: the least of these
    // squared distances.
    double least_of_farthest_squared(const Cell& cell) const;

    std::vector<Edge> edges_;
    RectangleTree tree_;
};

}  // namespace lacuna::verify
