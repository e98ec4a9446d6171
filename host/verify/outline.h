// Polygons as a proof sees them: how far a place is from their edges, and on which side.
#pragma once

#include <lacuna/lacuna.h>

#include <cstddef>
#include <span>
#include <vector>

#include "verify/cell.h"
#include "verify/mask_pixels.h"

namespace lacuna::verify {

// Rings with their edges in a tree of rectangles. An edge that two rings share is one of each.
class Outline {
public:
    // A ring is a list of points, the last of which is joined to the first.
    explicit Outline(std::span<const std::vector<Point>> rings);

    bool is_empty() const { return edges_.empty(); }

    // Whether a cell has places that lie deeper inside than `clearance`, which is positive: they
    // are open, and others closed. A cell near its edges may be said to have more than it has. One
    // that edges only touch is seen to be closed, so that none need be cut along an edge without an
    // end.
    Openness under(const Cell& cell, double clearance) const;

    // Distance to the nearest edge: positive inside, where an odd number of rings goes around, and
    // negative outside; infinitely so if there is no ring.
    double depth_of(Point place) const;

private:
    struct Edge {
        Point from;
        Point to;
    };
    // Of the edges in [begin, end): the nodes of its halves are 2 i + 1 and 2 i + 2.
    struct Node {
        Cell around;
        std::size_t begin;
        std::size_t end;

        bool is_leaf() const { return end - begin <= kFewEdges; }
    };
    static constexpr std::size_t kFewEdges = 4;

    static double squared_distance(Point place, const Edge& edge);
    void build(std::size_t node, std::size_t begin, std::size_t end);
    // The least of what `to_edge` says of edges, where of a node's edges it is at least `to_node`
    // of the rectangle around them.
    template <typename ToNode, typename ToEdge>
    double least(ToNode to_node, ToEdge to_edge) const;
    double nearest(Point place) const;
    bool is_inside(Point place) const;
    // How near an edge comes to the cell, squared, and how far from one all its places may be.
    double least_squared_distance(const Cell& cell) const;
    double least_of_farthest_squared(const Cell& cell) const;

    std::vector<Edge> edges_;
    std::vector<Node> nodes_;
};

}  // namespace lacuna::verify
