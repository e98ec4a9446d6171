// What a set with a field promises of each place: whether a sample may lie there, and its radius.
#pragma once

#include <lacuna/lacuna.h>

#include <optional>

#include "verify/cell.h"
#include "verify/domain.h"
#include "verify/radii.h"

namespace lacuna::verify {

// What lies under a cell, and perhaps a little beside it.
struct Under {
    RadiusRange radii;  // of the places where samples may lie, and of some where they may not

    // Nowhere under the cell may a sample lie.
    bool is_closed() const { return !radii.has_any(); }
    // Everywhere it may, with one radius: so it is under all parts of the cell.
    bool is_plain() const { return radii.is_one(); }
};

// Where a cell is cut in two.
struct Cut {
    bool is_of_x;
    double at;

    Cell low(Cell cell) const {
        (is_of_x ? cell.right : cell.top) = at;
        return cell;
    }
    Cell high(Cell cell) const {
        (is_of_x ? cell.left : cell.bottom) = at;
        return cell;
    }
};

// Radii that a sample may be said to have.
struct SampleRadii {
    double least;
    double most;
};

class Ground {
public:
    // The field must outlive this.
    Ground(const Domain& domain, const Field& field, double scale)
        : domain_(domain), radii_(domain, field, scale) {}

    const Domain& domain() const { return domain_; }
    double least_radius() const { return radii_.all().least; }

    // The rectangle outside of which no sample may lie.
    Cell bounds() const { return {0, domain_.width, 0, domain_.height}; }

    // `outer`: what is under a cell of which this one is a part.
    Under under(const Cell& cell, const Under& outer) const {
        return outer.is_plain() ? outer : Under{radii_.under(cell)};
    }

    // Where a cell is best halved: on a border of pixels, as long as its places differ.
    Cut cut(const Cell& cell, const Under& under) const;

    // The radius of a sample at a spot, if one may lie there.
    std::optional<double> radius_at(Point spot) const { return radii_.at(spot); }

    // Samplers work on a grid, to whose lines they round the borders of pixels. So a sample is said
    // to lie on every pixel that is as near as kBorderBlur of the longer side; nothing where none
    // of them may have a sample.
    std::optional<SampleRadii> radii_of_sample(Point at) const;

private:
    const Domain domain_;
    Radii radii_;
};

// Four units of a grid with 2^30 of them along the longer side: a border is off by up to two.
constexpr double kBorderBlur = 0x1p-28;

}  // namespace lacuna::verify
