// The parts of the search for the emptiest spot: rectangles, the points near one, the halving.
#pragma once

#include <lacuna/lacuna.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "verify/cell.h"
#include "verify/emptiest.h"
#include "verify/patience.h"

namespace lacuna::verify {

// Finds the points, and on a torus their images, that can be nearest to some spot of a cell.
class Neighbours {
public:
    // At least one point.
    Neighbours(const Domain& domain, std::span<const Point> points, const Patience& patience);

    std::vector<Point> of(const Cell& cell) const;
    const Domain& domain() const { return domain_; }

private:
    void append_within(double reach, const Cell& cell, std::vector<Point>& found) const;

    const Domain& domain_;
    std::vector<Point> by_x_;
};

// When a cell needs no more halving.
struct Goal {
    double relative;  // emptier by this share is not worth looking for,
    double finest;    // nor by this distance,
    double limit;     // once it is plain whether a spot is farther than this from every point
};

class Search {
public:
    // `rounding`: the most by which a distance may be off.
    Search(const Goal& goal, const Spot& start, double rounding, const Patience& patience)
        : goal_(goal), emptiest_(start), rounding_(rounding), patience_(patience) {}

    // The emptiest spot of the cell, if emptier than the start.
    Spot run(const Cell& cell, std::vector<Point> neighbours);

private:
    // The cell's neighbours are on the stack from `begin` on.
    void visit(const Cell& cell, std::size_t begin);
    // Sees whether the spot is emptier than the emptiest. The index of its nearest neighbour.
    std::size_t look_from_centre(Point centre, std::size_t begin);
    // Drops most neighbours of a cell that is far from a crowd: one that is no nearer to any of the
    // four corners than some other is no nearer to any spot, as the spots that are nearer to one of
    // two points are a half-plane.
    void thin_out(const Cell& cell, std::size_t begin);
    // A cell of which no spot is farther than this from every point needs no halving.
    double settled_from() const;

    Goal goal_;
    Spot emptiest_;
    double rounding_;
    const Patience& patience_;
    std::uint32_t visits_ = 0;
    std::vector<Point> stack_;  // the neighbours of each cell from the first to the one visited
};

}  // namespace lacuna::verify
