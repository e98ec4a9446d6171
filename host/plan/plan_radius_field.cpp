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
#include "plan/checked_request.h"
#include "plan/corner.h"
#include "plan/first_boxes.h"
#include "plan/make_plan.h"
#include "plan/outside.h"
#include "plan/plan.h"
#include "plan/radius_field.h"
#include "plan/sizes.h"

namespace lacuna {
namespace {

// The integral of the importance where samples of a class may lie, as a fraction of a domain that
// has the greatest importance everywhere.
double share_of(const Request& request, std::size_t of_class, double greatest, const Poll& poll) {
    const Field* const field = request.field;
    const Mask* const mask = mask_of(request, of_class);
    const double border = border_of(request, of_class);
    const double inside = (request.domain.width - 2 * border) / request.domain.width *
                          (request.domain.height - 2 * border) / request.domain.height;
    double sum = 0;
    if (mask == nullptr) {
        if (field == nullptr) return inside;
        for_each_polled(field->importance.size(), poll,
                        [&](std::size_t i) { sum += field->importance[i] / greatest; });
        return inside * sum / static_cast<double>(field->importance.size());
    }
    if (mask->drawn && field == nullptr) return inside * mask->drawn->tree.allowed_share();
    const auto middle_in = [](std::size_t i, std::size_t count, std::size_t pixels) {
        return (2 * i + 1) * pixels / (2 * count);
    };
    if (mask->drawn) {
        mask->drawn->tree.for_each_allowed([&](std::uint32_t column, std::uint32_t row,
                                               std::uint32_t columns, std::uint32_t rows) {
            // The pixels of a rectangle whose middles lie on one row of the field, and on one
            // column.
            const auto runs = [&](std::size_t first, std::size_t end, std::size_t count,
                                  std::size_t pixels) {
                std::vector<std::pair<std::size_t, double>> found;
                for (std::size_t i = first; i < end; ++i) {
                    const std::size_t pixel = middle_in(i, count, pixels);
                    if (found.empty() || found.back().first != pixel) found.emplace_back(pixel, 0);
                    found.back().second += 1;
                }
                return found;
            };
            const std::size_t top = mask->rows - row - rows;
            const auto across = runs(column, column + columns, mask->columns, field->columns);
            for (const auto& [down, lines] : runs(top, top + rows, mask->rows, field->rows))
                for (const auto& [right, pixels] : across)
                    sum += lines * pixels * field->importance[down * field->columns + right] /
                           greatest;
        });
        return inside * sum / mask->columns / mask->rows;
    }
    // For each pixel of a grid, mask and importance at its middle are taken.
    const auto share_on = [&](std::size_t columns, std::size_t rows) {
        sum = 0;
        const auto add_row = [&](std::size_t row) {
            const std::uint8_t* const allowed =
                &mask->allowed[middle_in(row, rows, mask->rows) * mask->columns];
            const double* const importance =
                field == nullptr
                    ? nullptr
                    : &field->importance[middle_in(row, rows, field->rows) * field->columns];
            for (std::size_t i = 0; i < columns; ++i) {
                if (allowed[middle_in(i, columns, mask->columns)] == 0) continue;
                sum += importance == nullptr
                           ? 1
                           : importance[middle_in(i, columns, field->columns)] / greatest;
            }
        };
        for_each_polled(rows, poll, add_row, columns);
        return inside * sum / (static_cast<double>(columns) * static_cast<double>(rows));
    };
    const double share = share_on(mask->columns, mask->rows);
    if (share > 0 || field == nullptr) return share;
    // The field may be 0 at the middles of all pixels of a mask that is coarser.
    return share_on(std::max(mask->columns, field->columns), std::max(mask->rows, field->rows));
}

double greatest_of(const Request& request) {
    if (request.field == nullptr) return 1;
    double greatest = 0;
    for_each_polled(request.field->importance.size(), ask, [&](std::size_t i) {
        greatest = std::max(greatest, request.field->importance[i]);
    });
    return greatest;
}

// The part of `own`, the request's domain, inside the border; `around` is the request with the
// domain of the plan. Distances from the edges are computed from the coordinates that the user
// gets, which are rounded when the corner is added.
RadiusField::Shape shape_of(const Request& around, const Domain& own, double border,
                            std::uint32_t width, std::uint32_t height,
                            std::uint32_t last_on_sheet) {
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
            last_on_sheet,
            lost_at_corner(all)};
}

// The radius of a kept point. It may lie on a pixel where no sample may, if that pixel's border is
// near and the other side is allowed (check_kept_place). Then the radius of the nearest position
// that has one is taken.
std::uint32_t radius_of_kept(const RadiusField& radius_field, Sample at) {
    std::uint32_t radius = radius_field.radius_at(at.x, at.y);
    constexpr std::uint32_t kFarthest = 8;  // 2^-28 of the longer side, plus rounding
    for (std::uint32_t far = 0; radius == 0 && far <= kFarthest; ++far) {
        const auto around = [far](const PixelAxis& axis, std::uint32_t middle) {
            const std::uint32_t end = axis.begin_of(axis.pixels());
            return pixels_of(axis, middle - std::min(middle, far), std::min(middle + far + 1, end));
        };
        radius = radius_field.radii()
                     .over(around(radius_field.columns(), at.x), around(radius_field.rows(), at.y))
                     .greatest();
    }
    return radius;
}

// The coordinates rounded down, or up if no sample may lie there: then the point belongs to the
// pixel on the other side. Points behind the first `members` lie outside of the request's domain,
// where all have one radius.
std::vector<Sized> kept_on(const RadiusField& radius_field, const Sheets& sheets,
                           const Request& request, std::size_t members) {
    const std::uint32_t width = radius_field.shape().width;
    const std::uint32_t height = radius_field.shape().height;
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
        const std::uint32_t right = std::min(low.x + 1, width - 1);
        const std::uint32_t up = std::min(low.y + 1, height - 1);
        Sample found = low;
        const bool is_member = kept.size() < members;
        for (const Sample near : {Sample{right, up}, Sample{low.x, up}, Sample{right, low.y}, low})
            if (is_member && radius_field.radius_at(near.x, near.y) != 0) found = near;
        const std::uint32_t sheet =
            sheets.are_several() ? request.keep_classes[kept.size()] : std::uint32_t{0};
        kept.push_back(
            {sheets.x_on(sheet, found.x), found.y,
             is_member ? radius_of_kept(radius_field, found) : radius_field.least_radius()});
    }
    return kept;
}

// The memory that all classes take, over that of one class that keeps the least distance. It grows
// with the number of first boxes, which are short on every sheet on which samples of a dense class
// are seen.
double crowd_of_boxes(const Request& request) {
    const Sheets sheets = sheets_of(request);
    double crowd = 0;
    for (std::uint32_t sheet = 0; sheet < sheets.count(); ++sheet) {
        const double length = static_cast<double>(sheets.factor_of_boxes(sheet)) / FACTOR_ONE;
        if (sheets.weight(sheet) != 0) crowd += 1 / (length * length);
    }
    return crowd;
}

// `samples` is the number that a class of the least distance has where it is alone.
void check_size(const Request& request, const std::string& option, const std::string& value,
                double least_radius, double samples) {
    constexpr double kBytesPerSample = 250, kBytesPerPixel = 12, kBytesPerMaskPixel = 4. / 3,
                     kBytesPerBox = 50;
    constexpr double kBytesPerEllipse = sizeof(portable::Ellipse);
    const double longer = request.domain.longer_side();
    if (!(least_radius >= longer * kSmallestRadius))
        throw BadRequest(option, value,
                         "makes the least radius " + shortest(least_radius) +
                             ": it must be at least " + shortest(longer * kSmallestRadius) +
                             ", the longer side / 2^20, or the grid's units run out");
    double bytes = samples * crowd_of_boxes(request) * kBytesPerSample;
    // Boxes of a class are cut along a mask of its own, down to the slots of the tree.
    const bool are_alike = !has_own_places(request.classes);
    const double boxes_of_pixel = are_alike ? 0 : kBytesPerBox;
    for (std::size_t i = 0; i < (are_alike ? 1 : request.classes.names.size()); ++i) {
        if (request.field != nullptr)
            bytes += static_cast<double>(request.field->importance.size()) * kBytesPerPixel +
                     static_cast<double>(request.field->stretches.size()) * kBytesPerEllipse;
        const Mask* const mask = mask_of(request, i);
        if (mask == nullptr) continue;
        bytes += static_cast<double>(mask->allowed.size()) * (kBytesPerMaskPixel + boxes_of_pixel);
        if (mask->drawn)
            bytes += static_cast<double>(mask->drawn->tree.nodes().size()) *
                     (sizeof(MaskTree::Node) + MaskTree::kSlots * boxes_of_pixel);
    }
    refuse_more_memory(request, option, value, bytes);
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

// The expected number of samples in all classes, if each were alone, over the number of a class
// that keeps the least distance.
double crowd_of(const Request& request) {
    const std::vector<double> distances = distances_of(request);
    const std::size_t count = std::max<std::size_t>(request.classes.names.size(), 1);
    double crowd = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double own = distances[i * (count + 1)];
        if (request.classes.weights.empty() || request.classes.weights[i] > 0)
            crowd += 1 / (own * own);
    }
    return crowd;
}

// The same share for all classes together: the mean of theirs, in proportion to their samples.
double share_of(const Request& request, double greatest, const Poll& poll) {
    if (!has_own_places(request.classes)) return share_of(request, 0, greatest, poll);
    const std::vector<double> distances = distances_of(request);
    const std::size_t count = request.classes.names.size();
    double samples = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double own = distances[i * (count + 1)];
        if (request.classes.weights.empty() || request.classes.weights[i] > 0)
            samples += share_of(request, i, greatest, poll) / (own * own);
    }
    return samples / crowd_of(request);
}

// Units along the longer side: no sheet may reach into the next, nor the last one beyond 32 bits.
double units_of(const Sheets& sheets) {
    return sheets.are_several() ? std::min(kRadiusFieldUnits, sheets.last()) : kRadiusFieldUnits;
}

}  // namespace

double radius_field_scale_for_count(const Request& request, double count, const Poll& poll) {
    const double greatest = greatest_of(request);
    const double share = share_of(request, greatest, poll);
    if (request.count && share == 0)
        throw BadRequest("count", std::to_string(*request.count),
                         "has no room: the field is 0 where the mask allows samples");
    // Limit for an importance so low that a single sample covers the whole domain.
    const double most = 2 * std::hypot(request.domain.width, request.domain.height);
    const double radius = std::min(most, std::sqrt(kTorusDensity * share * request.domain.width *
                                                   request.domain.height / count));
    const double size = radius * std::sqrt(greatest) * std::sqrt(crowd_of(request));
    // Small islands have more points than the formula says. So if it asks for a little less than
    // the least radius, that one is tried.
    constexpr double kLittle = 0.8;
    const double least = request.domain.longer_side() * kSmallestRadius * std::sqrt(greatest);
    return size > kLittle * least ? std::max(size, least) : size;
}

FieldSize check_radius_field_size(const Request& request, double size, const Poll& poll) {
    const std::string option = request.count              ? "count"
                               : request.field != nullptr ? "scale"
                                                          : "radius";
    const std::string value = request.count ? std::to_string(*request.count) : shortest(size);
    if (!std::isfinite(size) || size <= 0)
        throw BadRequest(option, value, "must be a finite number greater than 0");
    const double greatest = greatest_of(request);
    const double least_radius = size / std::sqrt(greatest);
    const double samples = kTorusDensity * share_of(request, greatest, poll) *
                           (request.domain.width / least_radius) *
                           (request.domain.height / least_radius);
    check_size(request, option, value, least_radius, samples);
    return {least_radius, samples * crowd_of(request)};
}

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
    field.sheets = sheets_of(request);
    const double units = units_of(field.sheets);
    Plan plan;
    plan.width = static_cast<std::uint32_t>(units * (around.domain.width / longer));
    plan.height = static_cast<std::uint32_t>(units * (around.domain.height / longer));
    plan.lines = 1;
    plan.strip_width = plan.width;
    const auto field_of = [&](double border, const Mask* mask) {
        return std::make_shared<const RadiusField>(
            request.field, scale, mask,
            shape_of(around, request.domain, border, plan.width, plan.height, field.sheets.last()),
            poll);
    };
    const bool are_alike = !has_own_places(around.classes);
    field.radius_field = are_alike ? field_of(around.border, around.mask) : field_of(0, nullptr);
    PlacesOfClasses places;
    for (std::uint32_t i = 0; !are_alike && i < field.sheets.count(); ++i)
        places.push_back(field_of(border_of(around, i), mask_of(around, i)));
    check_lengths(request, *field.radius_field);
    field.kept = kept_on(*field.radius_field, field.sheets, around, checked.members());
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
