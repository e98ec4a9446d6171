// The domain of a set, and where in it samples may lie.
#pragma once

#include <lacuna/errors.h>
#include <lacuna/export.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace LACUNA_API lacuna {

// A position in the user's own units.
struct Point {
    double x = 0;
    double y = 0;
    friend bool operator==(const Point&, const Point&) = default;
};

// What happens at the edges of the domain: they wrap (torus) or they do not (box).
enum class Boundary { box, torus };

// The rectangle [x0, x0 + width) x [y0, y0 + height), in the user's unit of length. Sides are over
// 0, neither over 1000 times the other. x0 and y0 are finite, at most 2^20 times the longer side
// from 0: beyond that doubles would run out of digits.
struct Domain {
    double width = 1;
    double height = 1;
    Boundary boundary = Boundary::box;
    double x0 = 0;  // the lower left corner
    double y0 = 0;

    // Whether a point lies in the domain. The upper edges belong to a box, too; on a torus they are
    // the lower ones.
    bool holds(Point point) const {
        const double right = x0 + width, top = y0 + height;
        return point.x >= x0 && point.y >= y0 && (wraps() ? point.x < right : point.x <= right) &&
               (wraps() ? point.y < top : point.y <= top);
    }
    // The way from the corner to a point of the domain, and the point at the end of such a way.
    Point from_corner(Point point) const {
        const double x = point.x - x0, y = point.y - y0;
        return {x < width ? x : width, y < height ? y : height};
    }
    Point at(Point way) const { return {x0 + way.x, y0 + way.y}; }

    bool has_corner() const { return x0 != 0 || y0 != 0; }
    bool wraps() const { return boundary == Boundary::torus; }
    double longer_side() const { return width < height ? height : width; }
    double shorter_side() const { return height < width ? height : width; }
    friend bool operator==(const Domain&, const Domain&) = default;
};
// Pixels that a domain is cut into: columns times rows equal rectangles. Columns count from the
// left and rows from the lowest one.
struct Raster {
    std::uint32_t columns = 0;
    std::uint32_t rows = 0;

    std::uint64_t pixels() const { return std::uint64_t{columns} * rows; }
    Point centre(std::uint32_t column, std::uint32_t row, const Domain& domain) const {
        return domain.at({domain.width * (2. * column + 1) / (2. * columns),
                          domain.height * (2. * row + 1) / (2. * rows)});
    }
    friend bool operator==(const Raster&, const Raster&) = default;
};
// The domain of a picture's shape, with a longer side of 1.
Domain domain_like(std::uint32_t columns, std::uint32_t rows, Boundary boundary = Boundary::box);

struct DrawnMask;  // internal: plan/mask_tree.h

// Where samples may lie, whatever the importance: pixels that are stretched over the domain. A
// sample on the border of two pixels lies in the right or the upper one.
struct Mask {
    std::uint32_t columns = 0;            // pixels
    std::uint32_t rows = 0;               // pixels
    std::vector<std::uint8_t> allowed{};  // rows * columns values (0: no sample there); row by row,
                                          // row 0 is the top of the picture (largest y)
    // Instead of `allowed`: what draw_places() of lacuna/places.h has drawn. It takes memory in
    // proportion to the length of the outlines, whatever the number of pixels.
    std::shared_ptr<const DrawnMask> drawn{};
    // The rectangle in which `allowed` lies, in place of the domain, such as a map's of which a
    // domain is a part. The domain's edges must lie on borders of its pixels. Beyond it no point
    // may lie.
    std::optional<Domain> extent{};
};

// A closed outline: its last point is joined to its first.
using PolygonRing = std::vector<Point>;

}  // namespace lacuna
