// The positions of dots on a page, and the strokes in which they are drawn.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <span>
#include <vector>

#include "drawing/pen_dot.h"
#include "drawing/picture.h"

namespace lacuna::drawing {

// Most dots in one stroke: a low number keeps the working memory of cairo, and of viewers, small.
inline constexpr std::size_t kDotsPerStroke = 4096;

// The page's sides, and the map from the domain (y upwards) to the page (y downwards).
struct Page {
    double width;
    double height;
    double scale;
    double left;    // where x is 0: the left edge of a domain whose corner is (0, 0)
    double bottom;  // where y is 0, counted from the page's top
    double x_of(Point point) const { return left + point.x * scale; }
    double y_of(Point point) const { return bottom - point.y * scale; }
};

// The page. A point, 1/72 inch, has `units_per_point` of its units.
Page page_of(const files::PointSet& set, const Style& style, double units_per_point);

// The diameter of the dots if all have the same.
double dot_diameter(const files::PointSet& set);

// The style's sheet with a margin that is wider by as much as the ink of a set's dots or lines
// reaches over the domain's edges: all ink then lies within the sheet's own margin.
Paper with_room_for_ink(const files::PointSet& set, const Style& style);

// Calls `stroke(points, diameter)` for dots of one size, at most kDotsPerStroke at a time.
template <class Stroke>
void for_each_stroke(std::span<const Point> points, double diameter, const Stroke& stroke) {
    for (std::size_t begin = 0; begin < points.size(); begin += kDotsPerStroke)
        stroke(points.subspan(begin, std::min(kDotsPerStroke, points.size() - begin)), diameter);
}

// The same for all dots of a set, in their order. If they have different sizes and are not for a
// pen, the smallest size comes first, and within a size the dots keep their order.
template <class Stroke>
void for_each_stroke(const files::PointSet& set, const Style& style, const Stroke& stroke) {
    if (style.diameters.empty()) return for_each_stroke(set.points, dot_diameter(set), stroke);
    std::vector<std::size_t> order(set.points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (!style.for_a_pen)
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return style.diameters[a] < style.diameters[b];
        });
    std::vector<Point> run;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const double diameter = style.diameters[order[i]];
        run.push_back(set.points[order[i]]);
        if (i + 1 < order.size() && style.diameters[order[i + 1]] == diameter) continue;
        for_each_stroke(std::span<const Point>(run), diameter, stroke);
        run.clear();
    }
}

// A dot of a set of ellipses, on the page: as large as its disk would be, stretched like the
// point's ellipse.
struct Oval {
    double x;
    double y;
    double a;  // the longer radius
    double b;
    double turn;  // in radians, from right towards the top of the page to a
};

// Calls `draw(oval)` for each dot of a set of ellipses.
template <class Draw>
void for_each_oval(const files::PointSet& set, const Style& style, const Page& page,
                   const Draw& draw) {
    for (std::size_t i = 0; i < set.points.size(); ++i) {
        const auto& [a, b, angle] = set.ellipses[i];
        const double diameter = style.diameters.empty() ? dot_diameter(set) : style.diameters[i];
        const double radius = diameter * page.scale / 2;
        draw(Oval{page.x_of(set.points[i]), page.y_of(set.points[i]), radius * std::sqrt(a / b),
                  radius * std::sqrt(b / a), angle});
    }
}

// A stroke of a pen on the page, between the middles of its round ends.
struct PenStroke {
    double x;
    double y;
    double way_x;
    double way_y;
    double width;
};

// Calls `draw(stroke)` for each dot of a set whose ellipses are strokes.
template <class Draw>
void for_each_pen_stroke(const files::PointSet& set, const Page& page, const Draw& draw) {
    for (std::size_t i = 0; i < set.points.size(); ++i) {
        const auto& [a, b, angle] = set.ellipses[i];
        const double way = 2 * (a - b) * page.scale;
        const double way_x = way * std::cos(angle), way_y = 0.0 - way * std::sin(angle);
        draw(PenStroke{page.x_of(set.points[i]) - way_x / 2, page.y_of(set.points[i]) - way_y / 2,
                       way_x, way_y, 2 * b * page.scale});
    }
}

// Calls `draw(x, y, dot, width)` for each dot of a set that a pen of the style draws: its middle on
// the page, and the pen's way and width there.
template <class Draw>
void for_each_pen_dot(const files::PointSet& set, const Style& style, const Page& page,
                      const Draw& draw) {
    const double width = style.pen_mm / millimetres_per_unit(set, style) * page.scale;
    for (std::size_t i = 0; i < set.points.size(); ++i) {
        const double diameter = style.diameters.empty() ? dot_diameter(set) : style.diameters[i];
        draw(page.x_of(set.points[i]), page.y_of(set.points[i]),
             pen_dot(diameter * page.scale, width, style.circles), width);
    }
}

// Calls `draw(layer, dots, style)` for each layer: its index, its dots as a set of their own, and
// the style with their diameters. A set without layers is drawn as one, with index 0.
using DrawLayer = std::function<void(std::size_t, const files::PointSet&, const Style&)>;
void for_each_layer(const files::PointSet& set, const Style& style, const DrawLayer& draw);

// The width of a layer's line on the page.
inline double line_width_of(const files::PointSet& set, std::size_t layer, const Style& style,
                            const Page& page) {
    const double pen_mm = set.layers.empty() ? 0 : set.layers[layer].ink.pen_mm;
    return page.scale *
           (pen_mm == 0 ? style.line_width : pen_mm / millimetres_per_unit(set, style));
}

}  // namespace lacuna::drawing
