// A cell's corners, which tell for all its spots which of two points is nearer.
#pragma once

#include <lacuna/lacuna.h>

#include <array>

#include "verify/cell.h"

namespace lacuna::verify {

// The squared distances of a point to a cell's corners.
struct Corners {
    using Squares = std::array<double, 4>;
    const Cell& cell;

    explicit Corners(const Cell& of) : cell(of) {}

    Squares to(Point p) const {
        const double left = square(p.x - cell.left);
        const double right = square(p.x - cell.right);
        const double bottom = square(p.y - cell.bottom);
        const double top = square(p.y - cell.top);
        return {left + bottom, right + bottom, left + top, right + top};
    }
};

}  // namespace lacuna::verify
