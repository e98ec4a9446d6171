// The radius field of a plan in mode exact: the radius at each position, from a field, and where
// samples may go, from a mask and a border (docs/design.md, section 4, "exact with a radius
// field").
#pragma once

#include <lacuna/lacuna.h>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/polling.h"
#include "plan/mask_tree.h"
#include "plan/pixels.h"
#include "portable/ellipse.h"
#include "portable/radius_field.h"

namespace lacuna {

struct Sample;

// Units along the longer side of a domain with a radius field. With 2^30 the square of its diagonal
// fits into 62 bits, and a radius longer than the diagonal into 31.
inline constexpr std::uint32_t kRadiusFieldUnits = std::uint32_t{1} << 30;

// The least radius with or without a radius field. With fewer units to a radius the rounding would
// show; and 1000 lines a radius need 2 units each.
inline constexpr double kSmallestRadius = 1.0 / (1 << 20);  // of the longer side

// What lies under a rectangle, and perhaps a little around it. With ellipses the least radius is
// that of a circle which all of them hold, and the greatest that of a circle which holds all.
struct Under {
    std::uint32_t least;     // least radius where samples may lie; 0: nowhere
    std::uint32_t greatest;  // greatest radius where samples may lie
    bool is_even;            // samples may lie everywhere, with one radius, or one ellipse
};

class RadiusField {
public:
    // Least and greatest of the radii that are not 0; both are 0 if there are none. Kernels read
    // the same words (portable/radius_field.h).
    struct Radii {
        std::uint32_t least;
        std::uint32_t greatest_and_zeros;  // the greatest, and a bit: whether some radii are 0
        std::uint32_t greatest() const { return greatest_and_zeros & ~HAS_ZEROS; }
        bool are_mixed() const;
    };
    static Radii merge_radii(Radii a, Radii b);
    using RadiusPyramid = Pyramid<Radii, merge_radii>;

    struct Shape {
        std::uint32_t width;  // of the domain
        std::uint32_t height;
        double unit_x;  // the user's units for one grid unit
        double unit_y;
        std::uint32_t low_x;  // samples lie in [low_x, high_x) times [low_y, high_y)
        std::uint32_t high_x;
        std::uint32_t low_y;
        std::uint32_t high_y;
        bool has_kept;  // whether there are kept points, whose coordinates are not in whole units
        double unit() const { return unit_x < unit_y ? unit_x : unit_y; }
        // All bits that x may have on one copy (plan/class_copies.h). The field is the same on all.
        std::uint32_t last_on_copy = ~std::uint32_t{0} >> 1;
        double lost = 0;  // by which radii are longer: lost_at_corner() of checks/domain.h
    };

    // Without a field the radius is `scale` everywhere.
    RadiusField(const Field* field, double scale, const Mask* mask, const Shape& shape,
                const Poll& poll = nobody_asks);

    const Shape& shape() const { return shape_; }
    // The least radius where samples may lie.
    std::uint32_t least_radius() const { return least_radius_; }

    // The radius at a position; 0 if no sample may lie there. With ellipses that of a circle which
    // holds the ellipse.
    std::uint32_t radius_at(std::uint32_t x, std::uint32_t y) const {
        const std::uint32_t at = x & shape_.last_on_copy;
        if (mask_ &&
            mask_->at(mask_columns_->pixel_of(at), mask_rows_->pixel_of(y)) == ALLOWED_NONE)
            return 0;
        return radii_.at(columns_.pixel_of(at), rows_.pixel_of(y)).greatest();
    }
    Under under(const Box& box) const;

    // Whether samples have ellipses, and the ellipse at a position.
    bool has_ellipses() const { return !ellipses_.empty(); }
    const portable::Ellipse& ellipse_at(std::uint32_t x, std::uint32_t y) const {
        return ellipses_[std::size_t{columns_.pixel_of(x & shape_.last_on_copy)} * rows_.pixels() +
                         rows_.pixel_of(y)];
    }
    // An ellipse that all samples in the box have, or a circle that lies in all their ellipses.
    // `found` is under(box), where samples may lie.
    portable::Ellipse ellipse_under(const Box& box, const Under& found) const {
        return found.is_even ? ellipse_at(box.x, box.begin) : portable::circle_of(found.least);
    }

    // Whether the mask allows a part of the box on a domain, and perhaps a little around it.
    bool is_mask_mixed(const Box& on_copy) const;
    // Where to halve a box: at a border of pixels near its middle if it lies on unlike pixels,
    // otherwise in the middle along x. 0 means that the box is not cut on this axis.
    std::uint32_t cut_x(const Box& box) const;
    std::uint32_t cut_y(const Box& box) const;

    // The data that these functions use, for devices. The mask's are null if there is no mask.
    const PixelAxis& columns() const { return columns_; }
    const PixelAxis& rows() const { return rows_; }
    const RadiusPyramid& radii() const { return radii_; }
    const PixelAxis* mask_columns() const { return mask_columns_ ? &*mask_columns_ : nullptr; }
    const PixelAxis* mask_rows() const { return mask_rows_ ? &*mask_rows_ : nullptr; }
    const MaskTree* mask() const { return mask_.get(); }
    const std::vector<portable::Ellipse>& ellipses() const { return ellipses_; }

private:
    std::vector<Radii> radii_of(const Field* field, double scale, const Poll& poll);
    void border_ellipses();
    Box on_domain(const Box& box) const {
        return {box.x & shape_.last_on_copy, box.width, box.begin, box.end};
    }
    bool are_radii_mixed(const Box& box) const;

    Shape shape_;
    PixelAxis columns_;
    PixelAxis rows_;
    std::vector<portable::Ellipse> ellipses_;  // of the pixels, column by column; empty: disks
    RadiusPyramid radii_;
    std::optional<PixelAxis> mask_columns_;
    std::optional<PixelAxis> mask_rows_;
    std::shared_ptr<const MaskTree> mask_;
    std::uint32_t least_radius_;
};

}  // namespace lacuna
