// The plan of mode exact with a radius field: for a field, a mask, a border or kept points
// (docs/design.md, section 4, "exact with a radius field").
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/number_text.h"
#include "checks/classes.h"
#include "checks/domain.h"
#include "plan/checked_request.h"
#include "plan/first_boxes.h"
#include "plan/make_plan.h"
#include "plan/outside.h"
#include "plan/plan.h"
#include "plan/radius_field.h"
#include "plan/sizes.h"

namespace lacuna {
namespace {

// The part of `own`, the request's domain, inside the border; `around` is the request with the
// domain of the plan. Distances from the edges are computed from the coordinates that the user
// gets, which are rounded when the corner is added.
RadiusField::Shape shape_of(const Request& around, const Domain& own, double border,
                            std::uint32_t width, std::uint32_t height, std::uint32_t last_on_copy) {
    const auto span_along = [border](double unit, std::uint32_t units, double corner,
                                     double own_corner, double length) {
        const auto way_to = [=](std::uint32_t at) { return (corner + at * unit) - own_corner; };
        const double before = own_corner - corner;
        auto low = static_cast<std::uint32_t>(
            std::max(0.0, (before + border) / unit - (before > 0 ? 2 : 0)));
        while (way_to(low) < border) ++low;
        auto high = static_cast<std::uint32_t>(
            std::min<double>(units, std::ceil((before + length - border) / unit) + 2));
        while (high > 0 && (length - way_to(high - 1) < border ||
                            corner + (high - 1) * unit >= own_corner + length))
            --high;
        return Span{low, high};
    };
    const Domain& all = around.domain;
    const double unit_x = all.width / width, unit_y = all.height / height;
    const Span x = span_along(unit_x, width, all.x0, own.x0, own.width);
    const Span y = span_along(unit_y, height, all.y0, own.y0, own.height);
    return {width,
            height,
            unit_x,
            unit_y,
            x.begin,
            x.end,
            y.begin,
            y.end,
            !around.keep.empty(),
            last_on_copy,
            lost_at_corner(all)};
}

// The position that is `by` units from another one, on a torus around it.
std::uint32_t shifted(std::uint32_t from, std::int64_t by, std::int64_t units, bool wraps) {
    const std::int64_t to = from + by;
    return static_cast<std::uint32_t>(wraps ? (to + units) % units
                                            : std::clamp<std::int64_t>(to, 0, units - 1));
}

// The radius of a kept point. It may lie on a pixel where no sample may, if that pixel's border is
// near and the other side is allowed (check_kept_place). Then the radius of the nearest position
// that has one is taken. On a torus the first positions lie beside the last ones.
std::uint32_t radius_of_kept(const RadiusField& radius_field, Sample at, bool wraps) {
    std::uint32_t radius = radius_field.radius_at(at.x, at.y);
    constexpr std::int64_t kFarthest = 8;  // 2^-28 of the longer side, plus rounding
    // A mask does not count: kept points may lie on outlines, farther from where samples may lie.
    const auto radius_beside = [&](std::int64_t x, std::int64_t y) {
        const RadiusField::Shape& shape = radius_field.shape();
        return radius_field.radii()
            .at(radius_field.columns().pixel_of(shifted(at.x, x, shape.width, wraps)),
                radius_field.rows().pixel_of(shifted(at.y, y, shape.height, wraps)))
            .greatest();
    };
    for (std::int64_t far = 0; radius == 0 && far <= kFarthest; ++far)
        for (std::int64_t x = -far; x <= far; ++x)
            for (std::int64_t y = -far; y <= far; ++y)
                radius = std::max(radius, radius_beside(x, y));
    return radius;
}

// The coordinates rounded down, or up if no sample may lie there: then the point belongs to the
// pixel on the other side. Points behind the first `members` lie outside of the request's domain,
// where all have one radius.
std::vector<Sized> kept_on(const RadiusField& radius_field, const ClassCopies& copies,
                           const Request& request, std::size_t members) {
    const std::uint32_t width = radius_field.shape().width;
    const std::uint32_t height = radius_field.shape().height;
    const bool wraps = request.domain.wraps();
    std::vector<Sized> kept;
    kept.reserve(request.keep.size());
    for (const Point& kept_point : request.keep) {
        ask_after(8);
        const Point point = request.domain.from_corner(kept_point);
        const auto along = [](double at, double unit, std::uint32_t units) {
            return std::min(static_cast<std::uint32_t>(at / unit), units - 1);
        };
        const Sample low{along(point.x, request.domain.width / width, width),
                         along(point.y, request.domain.height / height, height)};
        const std::uint32_t right = shifted(low.x, 1, width, wraps);
        const std::uint32_t up = shifted(low.y, 1, height, wraps);
        Sample found = low;
        const bool is_member = kept.size() < members;
        for (const Sample near : {Sample{right, up}, Sample{low.x, up}, Sample{right, low.y}, low})
            if (is_member && radius_field.radius_at(near.x, near.y) != 0) found = near;
        const std::uint32_t copy =
            copies.are_several() ? request.keep_classes[kept.size()] : std::uint32_t{0};
        kept.push_back(
            {copies.x_on(copy, found.x), found.y,
             is_member ? radius_of_kept(radius_field, found, wraps) : radius_field.least_radius()});
    }
    return kept;
}

// On a torus two samples see each other along the shorter way, which must be the only one in their
// ellipses.
void check_lengths(const Request& request, const RadiusField& radius_field) {
    const auto& [width, height] =
        std::pair(radius_field.shape().width, radius_field.shape().height);
    if (!request.domain.wraps() || !radius_field.has_ellipses()) return;
    const std::uint64_t length =
        2 * std::uint64_t{radius_field.under({0, width, 0, height}).greatest};
    if (length > std::min(width, height))
        throw BadRequest("torus",
                         "with an ellipse of length " +
                             rounded(static_cast<double>(length) * radius_field.shape().unit(), 6),
                         "must be at most the domain's shorter side, " +
                             shortest(request.domain.shorter_side()));
}

}  // namespace

Plan make_radius_field_plan(const CheckedRequest& checked, const Poll& poll,
                            std::span<const Sample> samples) {
    const Request& request = *checked;
    const bool has_field = request.field != nullptr;
    const double scale = has_field ? *request.scale : *request.radius;
    const auto [least_radius, expected] = check_radius_field_size(request, scale, poll);
    const Around outer = around_kept(request, poll);
    const Request& around = outer.request;
    const double longer = around.domain.longer_side();
    FieldPlan field;
    // No copy may reach into the next, nor the last one beyond 32 bits.
    const std::size_t classes = request.classes.names.size();
    const std::uint32_t last = ClassCopies::last_of(static_cast<std::uint32_t>(classes));
    const double units = std::min(kRadiusFieldUnits, last);  // along the longer side
    Plan plan;
    plan.width = static_cast<std::uint32_t>(units * (around.domain.width / longer));
    plan.height = static_cast<std::uint32_t>(units * (around.domain.height / longer));
    plan.lines = 1;
    plan.strip_width = plan.width;
    const auto field_of = [&](double border, const Mask* mask) {
        return std::make_shared<const RadiusField>(
            request.field, scale, mask,
            shape_of(around, request.domain, border, plan.width, plan.height, last), poll);
    };
    const bool are_alike = !has_own_places(around.places);
    field.radius_field =
        are_alike ? field_of(around.places.border, around.places.mask) : field_of(0, nullptr);
    PlacesOfClasses places;
    for (std::size_t i = 0; !are_alike && i < classes; ++i)
        places.push_back(field_of(border_of(around, i), mask_of(around, i)));
    check_lengths(request, *field.radius_field);
    field.copies =
        copies_of(request, field.radius_field->under({0, plan.width, 0, plan.height}).greatest);
    field.kept = kept_on(*field.radius_field, field.copies, around, checked.members());
    for (const Sample sample : samples)
        field.kept.push_back(
            {sample.x, sample.y, field.radius_field->radius_at(sample.x, sample.y)});
    plan.radius = field.radius_field->least_radius();
    plan.user_radius = least_radius;
    plan.user_scale = has_field ? scale : 0;
    const std::uint64_t limit = request.limit.value_or(std::numeric_limits<std::uint64_t>::max());
    const std::uint64_t members = checked.members() + samples.size();
    finish_plan(plan, around, limit - std::min(limit, members), expected);
    plan.of_mode = std::move(field);
    auto boxes = std::make_shared<const FirstBoxes>(first_boxes(plan, places));
    std::get<FieldPlan>(plan.of_mode).first_boxes = std::move(boxes);
    return plan;
}

}  // namespace lacuna
