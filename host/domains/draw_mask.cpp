// Draws polygons onto a mask, one row of pixels at a time.
//
// The code does not use cairo. Whether a pixel's middle lies inside must be the same on every
// machine and with every version of a library; cairo rounds corners to 1/256 of a pixel and draws
// at most 32,767 pixels a side. The even-odd rule makes a row simple: where an outline crosses the
// line through the middles of a row's pixels, all pixels to the right of it switch between inside
// and outside. Nothing is sorted, so even 100,000 crossings a row take linear time.
#include <fmt/core.h>
#include <lacuna/domains.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "domains/bands.h"
#include "domains/rings.h"
#include "files/read_whole.h"

namespace lacuna {
namespace {

using domains::first_middle_from;
using domains::near_rings;

constexpr double kMostPixelsASide = 1U << 24U;

// A piece of an outline, in pixels. It crosses the middles of the rows [first_row, end_row), which
// are counted from the bottom.
struct Side {
    double x;  // of the lower end
    double y;
    double slope;  // change of x per unit of y
    std::uint32_t first_row;
    std::uint32_t end_row;
};

// Always computed from the lower to the upper end, whatever the direction of the ring. So rings
// that coincide cross a row at exactly the same x.
Side side_between(Point lower, Point upper, std::uint32_t rows) {
    return {lower.x, lower.y, (upper.x - lower.x) / (upper.y - lower.y),
            first_middle_from(lower.y, rows), first_middle_from(upper.y, rows)};
}

void append_sides(const PolygonRing& ring, Point scale, std::uint32_t rows,
                  std::vector<Side>& sides) {
    if (ring.empty()) return;
    const auto in_pixels = [scale](Point point) {
        return Point{point.x * scale.x, point.y * scale.y};
    };
    Point from = in_pixels(ring.back());
    for (const Point& point : ring) {
        const Point to = in_pixels(point);
        const Side side =
            from.y < to.y ? side_between(from, to, rows) : side_between(to, from, rows);
        if (side.first_row < side.end_row) sides.push_back(side);
        from = to;
    }
}

// Fills a row of the mask from the sides that cross its middles. The row must hold zeros at first.
void fill_row(const std::vector<Side>& crossing, double middle, std::span<std::uint8_t> row) {
    const auto columns = static_cast<std::uint32_t>(row.size());
    std::uint32_t first = columns;
    for (const Side& side : crossing) {
        const double x = side.x + (middle - side.y) * side.slope;
        const std::uint32_t column = first_middle_from(x, columns);
        if (column == columns) continue;
        row[column] ^= 1U;
        first = std::min(first, column);
    }
    std::uint8_t inside = 0;
    for (std::uint8_t& pixel : row.subspan(first)) {
        inside ^= pixel;
        pixel = inside;
    }
}

void draw(std::vector<Side>& sides, Mask& mask) {
    std::sort(sides.begin(), sides.end(),
              [](const Side& a, const Side& b) { return a.first_row < b.first_row; });
    std::vector<Side> crossing;
    std::size_t next = 0;
    for (std::uint32_t row = 0; row < mask.rows; ++row) {
        crossing.erase(std::remove_if(crossing.begin(), crossing.end(),
                                      [row](const Side& side) { return side.end_row <= row; }),
                       crossing.end());
        for (; next < sides.size() && sides[next].first_row == row; ++next)
            crossing.push_back(sides[next]);
        if (crossing.empty()) continue;
        const std::size_t from_top = mask.rows - 1 - row;
        fill_row(crossing, row + 0.5,
                 std::span(mask.allowed).subspan(from_top * mask.columns, mask.columns));
    }
}

// The number of pixels at which half of a pixel's diagonal is at most `edge`.
std::uint32_t pixels_along(double length, double edge) {
    return static_cast<std::uint32_t>(std::max(1.0, std::ceil(length / (edge * std::sqrt(2.0)))));
}

void check_numbers(double width, double height, double edge, double most_bytes) {
    const auto is_a_side = [](double side) { return side >= 1e-100 && side <= 1e100; };
    if (!is_a_side(width) || !is_a_side(height))
        throw BadRequest("domain", fmt::format("{}x{}", width, height),
                         "the sides must lie between 1e-100 and 1e100");
    if (!std::isfinite(edge) || !(edge > 0))
        throw BadRequest("edge", fmt::format("{}", edge), "must be a finite number greater than 0");
    const double columns = std::ceil(width / (edge * std::sqrt(2.0)));
    const double rows = std::ceil(height / (edge * std::sqrt(2.0)));
    const double longer = std::max(columns, rows);
    if (columns * rows <= most_bytes && longer <= kMostPixelsASide) return;
    // 1 % more than needed, because both numbers of pixels are rounded up.
    const double coarser =
        edge * 1.01 * std::max(std::sqrt(columns * rows / most_bytes), longer / kMostPixelsASide);
    throw BadRequest(
        "edge", fmt::format("{}", edge),
        fmt::format("takes a mask of {:.0f} x {:.0f} pixels, {:.3g} GB, of which {:.3g} "
                    "GB are allowed: must be coarser, such as {:.2g}",
                    columns, rows, columns * rows / 1e9, most_bytes / 1e9, coarser));
}

struct Extent {
    Point least{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    Point most{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
};

Extent extent_of(std::span<const PolygonSet> sets) {
    Extent all;
    for (const PolygonSet& set : sets)
        for (const PolygonRing& ring : set.rings)
            for (const Point& point : ring) {
                all.least = {std::min(all.least.x, point.x), std::min(all.least.y, point.y)};
                all.most = {std::max(all.most.x, point.x), std::max(all.most.y, point.y)};
            }
    return all;
}

bool is_allowed(const PolygonSet& set) {
    return !set.forbidden;
}

bool keeps_distance(const PolygonSet& set) {
    return set.distance > 0;
}

const char* option_of(const PolygonSet& set) {
    return set.forbidden ? "outside" : "inside";
}

void check_rings(const PolygonSet& set) {
    for (std::size_t i = 0; i < set.rings.size(); ++i)
        for (const Point& point : set.rings[i])
            if (!domains::is_fair(point))
                throw BadRequest(option_of(set), fmt::format("ring {}", i),
                                 fmt::format("({}, {}): {}", point.x, point.y, domains::kFair));
}

// How far the middle of a pixel must be from the set's rings, so that all of the pixel keeps the
// distance. Borders of pixels are rounded to a grid of samplers, by 2^-28 of the longer side.
double reach_of(const PolygonSet& set, Point scale, const Mask& mask) {
    const double longer = std::max(mask.columns / scale.x, mask.rows / scale.y);
    return set.distance + std::hypot(1 / scale.x, 1 / scale.y) / 2 + longer * 0x1p-27;
}

// Allows the pixels inside of the set, or forbids them.
void add_set(const PolygonSet& set, bool is_only, Point scale, Mask& mask) {
    std::vector<Side> sides;
    for (const PolygonRing& ring : set.rings) append_sides(ring, scale, mask.rows, sides);
    if (is_only && !set.forbidden && set.distance == 0) return draw(sides, mask);
    const Mask empty{mask.columns, mask.rows, std::vector<std::uint8_t>(mask.allowed.size())};
    Mask inside = empty;
    draw(sides, inside);
    if (set.distance > 0) {
        const Mask near = near_rings(set.rings, reach_of(set, scale, mask), scale, empty);
        for (std::size_t i = 0; i < mask.allowed.size(); ++i)
            if (near.allowed[i] != 0) inside.allowed[i] = set.forbidden ? 1 : 0;
    }
    const std::uint8_t value = set.forbidden ? 0 : 1;
    for (std::size_t i = 0; i < mask.allowed.size(); ++i)
        if (inside.allowed[i] != 0) mask.allowed[i] = value;
}

[[noreturn]] void refuse_empty(std::span<const PolygonSet> sets, double width, double height,
                               double pixel) {
    std::vector<PolygonSet> allowed;
    std::copy_if(sets.begin(), sets.end(), std::back_inserter(allowed), is_allowed);
    const bool has_forbidden = allowed.size() != sets.size();
    const std::string domain = fmt::format("the domain, [0, {:.6g}) x [0, {:.6g})", width, height);
    if (allowed.empty())
        throw BadRequest("outside",
                         fmt::format("{} file{}", sets.size(), sets.size() == 1 ? "" : "s"),
                         fmt::format("must leave some of {} open", domain));
    std::size_t rings = 0;
    for (const PolygonSet& set : allowed) rings += set.rings.size();
    const Extent extent = extent_of(allowed);
    throw BadRequest(
        "inside",
        fmt::format("{} ring{} in [{:.10g}, {:.10g}] x [{:.10g}, {:.10g}]", rings,
                    rings == 1 ? "" : "s", extent.least.x, extent.most.x, extent.least.y,
                    extent.most.y),
        fmt::format("must enclose some of {}{}, and be wider than a pixel of the mask, {:.3g}",
                    domain, has_forbidden ? ", that --outside leaves open" : "", pixel));
}

}  // namespace

Mask draw_mask(std::span<const PolygonRing> rings, double width, double height, double edge,
               std::uint64_t memory_limit_bytes) {
    const PolygonSet only{rings};
    return draw_mask(std::span(&only, 1), width, height, edge, memory_limit_bytes);
}

Mask draw_mask(std::span<const PolygonSet> sets, double width, double height, double edge,
               std::uint64_t memory_limit_bytes) {
    const std::uint64_t most = memory_limit_bytes != 0 ? memory_limit_bytes : files::most_bytes();
    // Each of several sets is drawn onto a mask of its own.
    const bool has_distance = std::any_of(sets.begin(), sets.end(), keeps_distance);
    const double masks = has_distance ? 4 : sets.size() > 1 ? 2 : 1;
    check_numbers(width, height, edge, static_cast<double>(most) / masks);
    for (const PolygonSet& set : sets) {
        check_rings(set);
        if (!(set.distance >= 0 && std::isfinite(set.distance)))
            throw BadRequest("border", fmt::format("{}", set.distance),
                             "must be a finite number of at least 0");
    }
    Mask mask;
    mask.columns = pixels_along(width, edge);
    mask.rows = pixels_along(height, edge);
    const Point scale{mask.columns / width, mask.rows / height};
    const bool has_inside = std::any_of(sets.begin(), sets.end(), is_allowed);
    mask.allowed.assign(std::size_t{mask.columns} * mask.rows, has_inside ? 0 : 1);
    for (const bool forbidden : {false, true})
        for (const PolygonSet& set : sets)
            if (set.forbidden == forbidden) add_set(set, sets.size() == 1, scale, mask);
    if (std::find(mask.allowed.begin(), mask.allowed.end(), 1) != mask.allowed.end()) return mask;
    refuse_empty(sets, width, height, width / mask.columns);
}

}  // namespace lacuna
