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
    if (!parts.polygons.empty()) region_.emplace(parts.polygons);
    const std::vector<Stretch>& stretches = parts.field->stretches;
    shapes_.reserve(stretches.size());
    for (std::size_t i = 0; i < stretches.size(); ++i)
        shapes_.push_back(
            shape_from(parts.scale / std::sqrt(parts.field->importance[i]), stretches[i]));
}

Under RadiusField::under(const Cell& cell, const Under& outer) const {
    if (outer.is_plain()) return outer;
    Under under{radii_.under(cell), {true, false}, {true, false}};
    if (has_ellipses()) under.shape = only_shape_under(cell);
    if (mask_ && outer.mask.has_closed) under.mask = mask_->under(cell);
    if (region_ && outer.inside.has_closed && !under.is_closed())
        under.inside = region_->under(cell, clearance());
    return under;
}

Cut RadiusField::cut(const Cell& cell, const Under& under) const {
    const Frame frame(cell);
    const bool is_wide = under.shape != nullptr ? under.shape->length_of({frame.half_width, 0}) >=
                                                      under.shape->length_of({0, frame.half_height})
                                                : frame.half_width >= frame.half_height;
    Borders borders;
    if (!under.is_even()) borders.append(radii_, cell);
    if (under.mask.has_closed) borders.append(*mask_, cell);
    if (borders.of_x && (is_wide || !borders.of_y)) return {true, *borders.of_x};
    if (borders.of_y) return {false, *borders.of_y};
    return {is_wide, is_wide ? frame.centre.x : frame.centre.y};
}

bool RadiusField::is_closed(Point spot) const {
    if (mask_ && !mask_->at(spot).has_open) return true;
    return region_ && region_->depth_of(spot) <= clearance();
}

std::optional<double> RadiusField::radius_at(Point spot) const {
    if (is_closed(spot)) return std::nullopt;
    const RadiusRange pixel = radii_.at(spot);
    if (!pixel.has_any()) return std::nullopt;
    return pixel.least;
}

std::optional<Proof::Closed> RadiusField::closed_to_sample(Point at) const {
    const double to_edges =
        std::min(std::min(at.x, domain_.width - at.x), std::min(at.y, domain_.height - at.y));
    if (to_edges < border_ - blur()) return Proof::Closed::border;
    if (mask_ && !mask_->near(at, blur()).has_open) return Proof::Closed::mask;
    if (region_ && region_->depth_of(at) < -rounding()) return Proof::Closed::polygons;
    return std::nullopt;
}

std::variant<SampleRadii, Proof::Closed> RadiusField::radii_of_sample(Point at) const {
    if (const auto closed = closed_to_sample(at)) return *closed;
    const RadiusRange range = radii_.near(at, blur());
    if (!range.has_any()) return Proof::Closed::importance;
    return SampleRadii{range.least, range.most};
}

const EllipseShape* RadiusField::shape_of(std::uint32_t column, std::uint32_t row) const {
    const std::size_t from_top = radii_.rows().count() - 1 - row;
    const EllipseShape& shape = shapes_[from_top * radii_.columns().count() + column];
    return std::isfinite(shape.shorter) ? &shape : nullptr;
}

const EllipseShape* RadiusField::only_shape_under(const Cell& cell) const {
    const Span columns = radii_.columns().between(cell.left, cell.right);
    const Span rows = radii_.rows().between(cell.bottom, cell.top);
    const bool is_one = columns.first == columns.last && rows.first == rows.last;
    return is_one ? shape_of(columns.first, rows.first) : nullptr;
}

const EllipseShape* RadiusField::shape_at(Point spot, const Cell& cell) const {
    if (is_closed(spot)) return nullptr;
    const auto pixel_within = [](const Axis& axis, double at, double low, double high) {
        const Span span = axis.between(low, high);
        return std::clamp(axis.pixel_of(at), span.first, span.last);
    };
    return shape_of(pixel_within(radii_.columns(), spot.x, cell.left, cell.right),
                    pixel_within(radii_.rows(), spot.y, cell.bottom, cell.top));
}

std::variant<std::vector<const EllipseShape*>, Proof::Closed> RadiusField::shapes_of_sample(
    Point at) const {
    if (const auto closed = closed_to_sample(at)) return *closed;
    std::vector<const EllipseShape*> shapes;
    for (const double x : domain_.around(at.x, blur(), domain_.width))
        for (const double y : domain_.around(at.y, blur(), domain_.height)) {
            const EllipseShape* shape =
                shape_of(radii_.columns().pixel_of(x), radii_.rows().pixel_of(y));
            if (shape != nullptr && std::find(shapes.begin(), shapes.end(), shape) == shapes.end())
                shapes.push_back(shape);
        }
    if (shapes.empty()) return Proof::Closed::importance;
    return shapes;
}

}  // namespace lacuna::verify
