// The ellipse of a pixel, from its radii and its angle: as a quadratic form, and in whole numbers
// (portable/ellipse.h).
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>

#include "base/number_text.h"
#include "portable/ellipse.h"

namespace lacuna {

// The ellipse that a disk of this radius is stretched to. It has the area of the disk.
Ellipse stretched(double radius, const Stretch& stretch);

// The ellipse holds an offset if xx dx^2 + 2 xy dx dy + yy dy^2 < 1.
struct QuadraticForm {
    double xx;
    double xy;
    double yy;

    bool holds(double dx, double dy) const {
        return xx * dx * dx + 2 * xy * dx * dy + yy * dy * dy < 1;
    }
};
QuadraticForm form_of(const Ellipse& radii);

// An ellipse in grid units that holds that of the radii, and little more. It holds all offsets
// nearer than `inner`, and none that is not nearer than `outer`.
struct RoundedEllipse {
    portable::Ellipse ellipse;
    std::uint32_t inner;
    std::uint32_t outer;
};

// The radii are in the user's units, and a grid unit is unit_x by unit_y of these. They are
// enlarged by `more` grid units and by `lost`, in the user's units. `most` is the diagonal of the
// domain in grid units: what lies farther away need not be right.
struct GridOfEllipses {
    double unit_x;
    double unit_y;
    std::uint32_t more;
    double most;
    double lost = 0;  // lost_at_corner() of checks/domain.h
};
RoundedEllipse rounded(const Ellipse& radii, const GridOfEllipses& grid);

}  // namespace lacuna
