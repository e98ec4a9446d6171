// Where cells are cut, and the radii of samples and spots.
#include "verify/radius_field.h"

#include <algorithm>
#include <cmath>

namespace lacuna::verify {
namespace {

// Where a cell may be cut: on each axis, at the border of pixels that is nearest to its middle.
struct Borders {
    std::optional<double> of_x;
    std::optional<double> of_y;

    template <typename Picture>
    void append(const Picture& picture, const Cell& cell) {
        const auto nearer = [](const std::optional<double>& a, const std::optional<double>& b,
                               double middle) {
            if (!a || !b) return a ? a : b;
            return std::abs(*b - middle) < std::abs(*a - middle) ? b : a;
        };
        const Point middle = Frame(cell).centre;
        of_x = nearer(of_x, picture.columns().middle_border(cell.left, cell.right), middle.x);
        of_y = nearer(of_y, picture.rows().middle_border(cell.bottom, cell.top), middle.y);
    }
};

}  // namespace

RadiusField::RadiusField(const Domain& domain, const FieldParts& parts)
    : domain_(domain),
      radii_(domain, {parts.field, parts.scale}),
      edge_tolerance_(parts.edge_tolerance),
      border_(parts.border) {
    if (parts.mask != nullptr) mask_.emplace(domain, MaskLeaves{parts.mask});
    if (!parts.polygons.empty()) region_.emplace(parts.polygons, parts.edge_tolerance);
}

Under RadiusField::under(const Cell& cell, const Under& outer) const {
    if (outer.is_plain()) return outer;
    Under under{radii_.under(cell), {true, false}, {true, false}};
    if (mask_ && outer.mask.has_closed) under.mask = mask_->under(cell);
    if (region_ && outer.inside.has_closed && !under.is_closed())
        under.inside = region_->under(cell, clearance());
    return under;
}

Cut RadiusField::cut(const Cell& cell, const Under& under) const {
    const Frame frame(cell);
    const bool is_wide = frame.half_width >= frame.half_height;
    Borders borders;
    if (!under.radii.is_one()) borders.append(radii_, cell);
    if (under.mask.has_closed) borders.append(*mask_, cell);
    if (borders.of_x && (is_wide || !borders.of_y)) return {true, *borders.of_x};
    if (borders.of_y) return {false, *borders.of_y};
    return {is_wide, is_wide ? frame.centre.x : frame.centre.y};
}

std::optional<double> RadiusField::radius_at(Point spot) const {
    if (mask_ && !mask_->at(spot).has_open) return std::nullopt;
    if (region_ && region_->depth_of(spot) <= clearance()) return std::nullopt;
    const RadiusRange pixel = radii_.at(spot);
    if (!pixel.has_any()) return std::nullopt;
    return pixel.least;
}

std::variant<SampleRadii, Proof::Closed> RadiusField::radii_of_sample(Point at) const {
    const double blur = kBorderBlur * domain_.longer_side();
    const double to_edges =
        std::min(std::min(at.x, domain_.width - at.x), std::min(at.y, domain_.height - at.y));
    if (to_edges < border_ - blur) return Proof::Closed::border;
    if (mask_ && !mask_->near(at, blur).has_open) return Proof::Closed::mask;
    if (region_ && region_->depth_of(at) < -(edge_tolerance_ + blur))
        return Proof::Closed::polygons;
    const RadiusRange range = radii_.near(at, blur);
    if (!range.has_any()) return Proof::Closed::importance;
    return SampleRadii{range.least, range.most};
}

}  // namespace lacuna::verify
