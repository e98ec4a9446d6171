// What a set promises of each place: whether a sample may lie there, and with which radius.
#pragma once

#include <lacuna/lacuna.h>
#include <lacuna/verify.h>

#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "verify/cell.h"
#include "verify/domain.h"
#include "verify/emptiest.h"
#include "verify/mask_pixels.h"
#include "verify/outline.h"
#include "verify/radii.h"

namespace lacuna::verify {

// Where samples may lie, and their radii. What is pointed to must outlive its Ground.
struct Places {
    const Field* field;
    double scale;
    const Mask* mask = nullptr;                  // null: everywhere
    std::span<const std::vector<Point>> inside;  // rings; none: everywhere
    double edge_tolerance = 0;                   // how far the edges of `inside` may be off
    double border = 0;                           // least distance to the domain's edges
};

// What lies under a cell, and perhaps a little beside it.
struct Under {
    RadiusRange radii;  // of the places where samples may lie, and of some where they may not
    Openness mask{true, true};
    Openness inside{true, true};

    // Nowhere under the cell may a sample lie.
    bool is_closed() const { return !radii.has_any() || !mask.has_open || !inside.has_open; }
    // Everywhere it may, with one radius: so it is under all parts of the cell.
    bool is_plain() const { return radii.is_one() && !mask.has_closed && !inside.has_closed; }
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
    Ground(const Domain& domain, const Places& places);

    const Domain& domain() const { return domain_; }
    double least_radius() const { return radii_.all().least; }

    // The rectangle outside of which no sample may lie; empty where its right is left of its left.
    Cell bounds() const {
        return {border_, domain_.width - border_, border_, domain_.height - border_};
    }

    // `outer`: what is under a cell of which this one is a part.
    Under under(const Cell& cell, const Under& outer) const;

    // Where a cell is best halved: on a border of pixels, as long as its places differ.
    Cut cut(const Cell& cell, const Under& under) const;

    // The radius of a spot within the bounds that must be covered; nothing where none must. Spots
    // that are no farther inside of polygons than their edges may be off need not be.
    std::optional<double> radius_at(Point spot) const;

    // Samplers work on a grid, to whose lines they round the borders of pixels. So a sample is said
    // to lie on every pixel that is as near as kBorderBlur of the longer side. Else why none may
    // lie there.
    std::variant<SampleRadii, Proof::Closed> radii_of_sample(Point at) const;

private:
    // How deep inside the polygons a spot must lie to need a sample: what their edges may be off
    // by, and a little, as doubles have but so many digits.
    double clearance() const { return edge_tolerance_ + 4 * kFinest * domain_.longer_side(); }

    const Domain domain_;
    Radii radii_;
    std::optional<MaskPixels> mask_;
    std::optional<Outline> outline_;
    double edge_tolerance_;
    double border_;
};

// Four units of a grid with 2^30 of them along the longer side: a border is off by up to two.
constexpr double kBorderBlur = 0x1p-28;

}  // namespace lacuna::verify
