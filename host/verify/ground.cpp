// Where cells are cut, and what samples and spots lie on.
#include "verify/ground.h"

#include <algorithm>
#include <cmath>

namespace lacuna::verify {
namespace {

// Where a cell may be cut: on the border of each axis that is nearest to its middle.
struct Borders {
    std::optional<double> of_x;
    std::optional<double> of_y;

    template <typename Pixels>
    void append(const Pixels& pixels, const Cell& cell) {
        const auto nearer = [](const std::optional<double>& a, const std::optional<double>& b,
                               double middle) {
            if (!a || !b) return a ? a : b;
            return std::abs(*b - middle) < std::abs(*a - middle) ? b : a;
        };
        const Point middle = Frame(cell).centre;
        of_x = nearer(of_x, pixels.columns().middle_border(cell.left, cell.right), middle.x);
        of_y = nearer(of_y, pixels.rows().middle_border(cell.bottom, cell.top), middle.y);
    }
};

}  // namespace

Ground::Ground(const Domain& domain, const Places& places)
    : domain_(domain),
      radii_(domain, *places.field, places.scale),
      edge_tolerance_(places.edge_tolerance),
      border_(places.border) {
    if (places.mask != nullptr) mask_.emplace(domain, *places.mask);
    if (!places.inside.empty()) outline_.emplace(places.inside);
}

Under Ground::under(const Cell& cell, const Under& outer) const {
    if (outer.is_plain()) return outer;
    Under under;
    under.radii = radii_.under(cell);
    const bool is_mask_mixed = outer.mask.has_closed && mask_;
    under.mask = is_mask_mixed ? mask_->under(cell) : Openness{true, false};
    const bool is_edge_near = outer.inside.has_closed && outline_;
    if (is_edge_near && !under.is_closed()) {
        under.inside = outline_->under(cell, clearance());
    } else {
        under.inside = {true, false};
    }
    return under;
}

Cut Ground::cut(const Cell& cell, const Under& under) const {
    const Frame frame(cell);
    const bool is_wide = frame.half_width >= frame.half_height;
    Borders borders;
    if (!under.radii.is_one()) borders.append(radii_, cell);
    if (under.mask.has_closed) borders.append(*mask_, cell);
    if (borders.of_x && (is_wide || !borders.of_y)) return {true, *borders.of_x};
    if (borders.of_y) return {false, *borders.of_y};
    return {is_wide, is_wide ? frame.centre.x : frame.centre.y};
}

std::optional<double> Ground::radius_at(Point spot) const {
    if (mask_ && !mask_->is_open(spot)) return std::nullopt;
    if (outline_ && outline_->depth_of(spot) <= clearance()) return std::nullopt;
    return radii_.at(spot);
}

std::variant<SampleRadii, Proof::Closed> Ground::radii_of_sample(Point at) const {
    const double blur = kBorderBlur * domain_.longer_side();
    const double to_edges =
        std::min(std::min(at.x, domain_.width - at.x), std::min(at.y, domain_.height - at.y));
    if (to_edges < border_ - blur) return Proof::Closed::border;
    if (mask_ && !mask_->is_open_near(at, blur)) return Proof::Closed::mask;
    if (outline_ && outline_->depth_of(at) < -(edge_tolerance_ + blur))
        return Proof::Closed::polygons;
    const RadiusRange range = radii_.near(at, blur);
    if (!range.has_any()) return Proof::Closed::importance;
    return SampleRadii{range.least, range.most};
}

}  // namespace lacuna::verify
