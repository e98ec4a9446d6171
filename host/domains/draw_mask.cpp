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
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "domains/rings.h"
#include "files/read_whole.h"

namespace lacuna {
namespace {

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

// The first pixel whose middle is at or above `at`. The result is clamped to the mask, so that the
// ends of two adjoining pieces always agree.
std::uint32_t first_middle_from(double at, std::uint32_t pixels) {
    return static_cast<std::uint32_t>(
        std::clamp(std::ceil(at - 0.5), 0.0, static_cast<double>(pixels)));
}

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

// Fills a row of the mask from the sides that cross its middles. Returns whether any pixel is
// allowed. The row must hold zeros at first.
bool fill_row(const std::vector<Side>& crossing, double middle, std::span<std::uint8_t> row) {
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
    bool any = false;
    for (std::uint8_t& pixel : row.subspan(first)) {
        inside ^= pixel;
        pixel = inside;
        any |= inside != 0;
    }
    return any;
}

bool draw(std::vector<Side>& sides, Mask& mask) {
    std::sort(sides.begin(), sides.end(),
              [](const Side& a, const Side& b) { return a.first_row < b.first_row; });
    std::vector<Side> crossing;
    bool any = false;
    std::size_t next = 0;
    for (std::uint32_t row = 0; row < mask.rows; ++row) {
        crossing.erase(std::remove_if(crossing.begin(), crossing.end(),
                                      [row](const Side& side) { return side.end_row <= row; }),
                       crossing.end());
        for (; next < sides.size() && sides[next].first_row == row; ++next)
            crossing.push_back(sides[next]);
        if (crossing.empty()) continue;
        const std::size_t from_top = mask.rows - 1 - row;
        any |= fill_row(crossing, row + 0.5,
                        std::span(mask.allowed).subspan(from_top * mask.columns, mask.columns));
    }
    return any;
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

Extent extent_of(std::span<const PolygonRing> rings) {
    Extent all;
    for (const PolygonRing& ring : rings)
        for (const Point& point : ring) {
            all.least = {std::min(all.least.x, point.x), std::min(all.least.y, point.y)};
            all.most = {std::max(all.most.x, point.x), std::max(all.most.y, point.y)};
        }
    return all;
}

}  // namespace

Mask draw_mask(std::span<const PolygonRing> rings, double width, double height, double edge,
               std::uint64_t memory_limit_bytes) {
    const std::uint64_t most = memory_limit_bytes != 0 ? memory_limit_bytes : files::most_bytes();
    check_numbers(width, height, edge, static_cast<double>(most));
    for (std::size_t i = 0; i < rings.size(); ++i)
        for (const Point& point : rings[i])
            if (!domains::is_fair(point))
                throw BadRequest("inside", fmt::format("ring {}", i),
                                 fmt::format("({}, {}): {}", point.x, point.y, domains::kFair));
    Mask mask;
    mask.columns = pixels_along(width, edge);
    mask.rows = pixels_along(height, edge);
    const Point scale{mask.columns / width, mask.rows / height};
    std::vector<Side> sides;
    for (const PolygonRing& ring : rings) append_sides(ring, scale, mask.rows, sides);
    mask.allowed.resize(std::size_t{mask.columns} * mask.rows);
    if (draw(sides, mask)) return mask;
    const Extent extent = extent_of(rings);
    throw BadRequest(
        "inside",
        fmt::format("{} ring{} in [{:.10g}, {:.10g}] x [{:.10g}, {:.10g}]", rings.size(),
                    rings.size() == 1 ? "" : "s", extent.least.x, extent.most.x, extent.least.y,
                    extent.most.y),
        fmt::format("must enclose some of the domain, [0, {:.6g}) x [0, {:.6g}), and be wider "
                    "than a pixel of the mask, {:.3g}",
                    width, height, width / mask.columns));
}

}  // namespace lacuna
