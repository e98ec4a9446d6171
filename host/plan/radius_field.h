// The radius field of a plan in mode exact whose radii differ or where not all of the domain is
// allowed: what radius each place asks for, as a field says it, and where samples may go, as a mask
// does (docs/design.md, section 4, "exact with a field").
#pragma once

#include <lacuna/lacuna.h>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/polling.h"
#include "plan/pixels.h"

namespace lacuna {

struct Sample;

// The longer side of a domain with a radius field: the squares of its diagonal then fit 62 bits,
// and a radius that is longer than the diagonal 31.
inline constexpr std::uint32_t kRadiusFieldUnits = std::uint32_t{1} << 30;

// No radius is less, with a radius field or elsewhere: with fewer units to a radius, rounding it up
// would show; and 1000 lines a radius need 2 units each.
inline constexpr double kSmallestRadius = 1.0 / (1 << 20);  // of the longer side

// What lies under a rectangle, and perhaps a little around it.
struct Under {
    std::uint32_t least;     // of the radii of its places that are allowed; 0: none is
    std::uint32_t greatest;  // the same
    bool is_even;            // all of it is allowed, and has this radius
};

class RadiusField {
public:
    // Of the radii that are not 0; all is 0 where there are none. The words are those that kernels
    // read (portable/radius_field.h).
    struct Radii {
        std::uint32_t least;
        std::uint32_t greatest_and_zeros;  // whether there are any
        std::uint32_t greatest() const;
        bool are_mixed() const;
    };
    static Radii merge_radii(Radii a, Radii b);
    using RadiusPyramid = Pyramid<Radii, merge_radii>;

    // How much of pixels is allowed.
    static constexpr std::uint8_t kNone = 0, kSome = 1, kAll = 2;
    static std::uint8_t merge_allowed(std::uint8_t a, std::uint8_t b) { return a == b ? a : kSome; }
    using Allowed = Pyramid<std::uint8_t, merge_allowed>;

    struct Shape {
        std::uint32_t width;  // of the domain
        std::uint32_t height;
        double unit;          // the user's units for one grid unit, the smaller of two
        std::uint32_t low_x;  // samples lie in [low_x, high_x) times [low_y, high_y)
        std::uint32_t high_x;
        std::uint32_t low_y;
        std::uint32_t high_y;
        bool has_kept;  // samples that were placed by others
    };

    // Without a field the radius is `scale` everywhere.
    RadiusField(const Field* field, double scale, const Mask* mask, const Shape& shape,
                const Poll& poll = nobody_asks);

    const Shape& shape() const { return shape_; }
    // Of all places that are allowed.
    std::uint32_t least_radius() const { return least_radius_; }

    // 0 where no sample may go.
    std::uint32_t radius_at(std::uint32_t x, std::uint32_t y) const {
        if (mask_ && mask_->at(mask_columns_->pixel_of(x), mask_rows_->pixel_of(y)) == kNone)
            return 0;
        return radii_.at(columns_.pixel_of(x), rows_.pixel_of(y)).least;
    }
    Under under(const Rectangle& place) const;

    // Where to cut the place in two: along a border of pixels near its middle where it lies on
    // unlike ones, or else, along x, in its middle. 0 where it is not to be cut.
    std::uint32_t cut_x(const Rectangle& place) const;
    std::uint32_t cut_y(const Rectangle& place) const;

    // What all this is found with, for devices. The mask's are null where there is none.
    const PixelAxis& columns() const { return columns_; }
    const PixelAxis& rows() const { return rows_; }
    const RadiusPyramid& radii() const { return radii_; }
    const PixelAxis* mask_columns() const { return mask_columns_ ? &*mask_columns_ : nullptr; }
    const PixelAxis* mask_rows() const { return mask_rows_ ? &*mask_rows_ : nullptr; }
    const Allowed* mask() const { return mask_ ? &*mask_ : nullptr; }

private:
    static std::vector<Radii> radii_of(const Field* field, double scale, const Shape& shape,
                                       const Poll& poll);
    bool is_mask_mixed(const Rectangle& place) const;
    bool are_radii_mixed(const Rectangle& place) const;

    Shape shape_;
    PixelAxis columns_;
    PixelAxis rows_;
    RadiusPyramid radii_;
    std::optional<PixelAxis> mask_columns_;
    std::optional<PixelAxis> mask_rows_;
    std::optional<Allowed> mask_;
    std::uint32_t least_radius_;
};

}  // namespace lacuna
