// The radius field: what a sample at a place asks for as its radius, and where none may lie.
#pragma once

#include <lacuna/lacuna.h>
#include <lacuna/verify.h>

#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "verify/cell.h"
#include "verify/domain.h"
#include "verify/ellipse.h"
#include "verify/pixels.h"
#include "verify/region.h"

namespace lacuna::verify {

// Differences of distances below this share of the longer side are neglected.
constexpr double kFinest = 1e-12;

// How far, as a share of the longer side, the borders of pixels may be off. Samplers round borders
// to the lines of a grid, by up to two units. This is four units of a grid of 2^30 units.
constexpr double kBorderBlur = 0x1p-28;

// What a radius field is made of. All that is pointed to must outlive the radius field.
struct FieldParts {
    const Field* field;
    double scale;                          // radius where the importance is 1
    const Mask* mask = nullptr;            // null: samples may lie everywhere
    std::span<const PolygonSet> polygons;  // no set: samples may lie everywhere
    double edge_tolerance = 0;             // spots this near to polygons' edges are not covered
    double border = 0;                     // least distance to the domain's edges
};

// What lies under a cell, and perhaps a little beside it.
struct Under {
    RadiusRange radii;  // also of places where mask or polygons allow no sample
    Openness mask{true, true};
    Openness inside{true, true};
    const EllipseShape* shape = nullptr;  // the ellipse, if the cell lies on one pixel that has one

    // No sample may lie anywhere under the cell.
    bool is_closed() const { return !radii.has_any() || !mask.has_open || !inside.has_open; }
    // All spots that have a radius have the same one, or the same ellipse.
    bool is_even() const { return radii.is_one() || shape != nullptr; }
    // Samples may lie everywhere, with one radius. So this also describes all parts of the cell.
    bool is_plain() const { return is_even() && !mask.has_closed && !inside.has_closed; }
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

// The smallest and the largest radius that a sample may have, as borders of pixels are blurred.
struct SampleRadii {
    double least;
    double most;
};

class RadiusField {
public:
    RadiusField(const Domain& domain, const FieldParts& parts);

    const Domain& domain() const { return domain_; }
    double least_radius() const { return radii_.all().least; }
    double most_radius() const { return radii_.all().most; }
    bool has_ellipses() const { return !shapes_.empty(); }

    // The rectangle outside of which no sample may lie. It is empty if its right side is left of
    // its left side.
    Cell bounds() const {
        return {border_, domain_.width - border_, border_, domain_.height - border_};
    }

    // `outer`: what is under a larger cell that contains this one.
    Under under(const Cell& cell, const Under& outer) const;

    // Where a cell is best halved: on a border of pixels, as long as its pixels differ.
    Cut cut(const Cell& cell, const Under& under) const;

    // The radius of a spot within the bounds, or nothing if the spot need not be covered. A spot
    // need not be covered if it is no deeper inside the polygons than their edges may be off.
    std::optional<double> radius_at(Point spot) const;

    // The radii of a sample, or why no sample may lie at this place. A sample counts as lying on
    // every pixel that is no farther away than kBorderBlur.
    std::variant<SampleRadii, Proof::Closed> radii_of_sample(Point at) const;

    // The same with ellipses. A spot of a cell has the ellipse of a pixel under the cell, even if
    // it is rounded to a border; null if it need not be covered. A sample may have several.
    const EllipseShape* shape_at(Point spot, const Cell& cell) const;
    std::variant<std::vector<const EllipseShape*>, Proof::Closed> shapes_of_sample(Point at) const;

private:
    double rounding() const { return 4 * kFinest * domain_.longer_side(); }  // of doubles
    // How deep inside the polygons a spot must lie to need a sample.
    double clearance() const { return edge_tolerance_ + rounding(); }

    // Whether mask or polygons say that a spot need not be covered.
    bool is_closed(Point spot) const;
    // What forbids a sample, other than importance.
    std::optional<Proof::Closed> closed_to_sample(Point at) const;
    double blur() const { return kBorderBlur * domain_.longer_side(); }
    const EllipseShape* shape_of(std::uint32_t column, std::uint32_t row) const;
    const EllipseShape* only_shape_under(const Cell& cell) const;

    const Domain domain_;
    Pixels<FieldLeaves> radii_;
    std::vector<EllipseShape> shapes_;  // of the pixels, as in the field; empty: disks
    std::optional<Pixels<MaskLeaves>> mask_;
    std::optional<Region> region_;
    double edge_tolerance_;
    double border_;
};

}  // namespace lacuna::verify
