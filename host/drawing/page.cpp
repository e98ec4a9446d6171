// Pages: the domain alone, or the domain on a sheet of paper.
#include "drawing/page.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/angle.h"
#include "base/polling.h"
#include "plan/sizes.h"

namespace lacuna::drawing {
namespace {

constexpr double kLongerSideInPoints = 512;

// The page on which the domain's lower left corner lies at (left, bottom).
Page page_with(const Domain& domain, double width, double height, double scale, double left,
               double bottom) {
    return {width, height, scale, left - domain.x0 * scale, bottom + domain.y0 * scale};
}

// How far ink reaches over the domain's edges, in the domain's units.
double overhang_of(const files::PointSet& set, const Style& style) {
    const Domain& domain = set.domain;
    double overhang = 0;
    for (std::size_t i = 0; i < set.points.size(); ++i) {
        ask_after();
        double x = style.line_width / 2, y = x;  // half of the ink's width and height
        if (style.line_width == 0)
            x = y = (style.diameters.empty() ? dot_diameter(set) : style.diameters[i]) / 2;
        if (!set.ellipses.empty()) {
            const auto& [a, b, angle] = set.ellipses[i];
            const double longer = x * std::sqrt(a / b), shorter = x * std::sqrt(b / a);
            const Direction way = direction_of(angle);
            const auto half = [&](double cosine, double sine) {
                const double u = longer * cosine, v = shorter * sine;
                return std::sqrt(u * u + v * v);
            };
            x = half(way.x, way.y);
            y = half(way.y, way.x);
        }
        const Point at = domain.from_corner(set.points[i]);
        overhang = std::max(
            {overhang, x - at.x, x - (domain.width - at.x), y - at.y, y - (domain.height - at.y)});
    }
    return overhang;
}

}  // namespace

Paper with_room_for_ink(const files::PointSet& set, const Style& style) {
    Paper sheet = *style.sheet;
    const double overhang = overhang_of(set, style);
    Domain inked = set.domain;
    inked.width += 2 * overhang;
    inked.height += 2 * overhang;
    sheet.margin_mm += overhang * millimetres_per_unit(files::PointSet{{}, inked}, style);
    return sheet;
}

Page page_of(const files::PointSet& set, const Style& style, double units_per_point) {
    if (!style.sheet) {
        const double longer = set.domain.longer_side();
        const double longer_side = kLongerSideInPoints * units_per_point;
        const double height = longer_side * (set.domain.height / longer);
        return page_with(set.domain, longer_side * (set.domain.width / longer), height,
                         longer_side / longer, 0, height);
    }
    const double unit = units_per_point * kPointsPerInch / kMillimetresPerInch;
    const double scale = unit * millimetres_per_unit(set, style);
    const double width = style.sheet->width_mm * unit, height = style.sheet->height_mm * unit;
    return page_with(set.domain, width, height, scale, (width - set.domain.width * scale) / 2,
                     (height + set.domain.height * scale) / 2);
}

Shown shown(const Stippling& stippling) {
    const Request& request = stippling.request;
    Shown shown{{stippling.result.points, request.domain, stippling.result.radius}, {}};
    shown.set.is_relaxed = stippling.iterations != 0;
    shown.set.layers = stippling.layers;
    shown.set.ellipses = stippling.ellipses;
    shown.style.sheet = stippling.paper;
    shown.style.diameters = stippling.diameters;
    shown.style.are_strokes = stippling.are_strokes;
    shown.style.pen_mm = stippling.pen_mm;
    shown.style.circles = stippling.circles;
    shown.style.line_width = stippling.line_width;
    shown.style.paper_colour = stippling.paper_colour;
    shown.style.layer_plots = stippling.layer_plots;
    shown.style.for_a_pen = stippling.is_for_a_pen;
    return shown;
}

double millimetres_per_unit(const files::PointSet& set, const Style& style) {
    if (!style.sheet)
        return kLongerSideInPoints / kPointsPerInch * kMillimetresPerInch /
               set.domain.longer_side();
    const Paper& sheet = *style.sheet;
    return std::min((sheet.width_mm - 2 * sheet.margin_mm) / set.domain.width,
                    (sheet.height_mm - 2 * sheet.margin_mm) / set.domain.height);
}

Paper turned(const Paper& paper, const Domain& domain) {
    Paper lies = paper;
    if (paper.may_turn && domain.width > domain.height) std::swap(lies.width_mm, lies.height_mm);
    return lies;
}

void check(const Paper& paper) {
    const double shorter = std::min(paper.width_mm, paper.height_mm);
    if (!(paper.margin_mm >= 0 && 2 * paper.margin_mm < shorter))
        throw BadRequest("margin", fmt::format("{}mm", paper.margin_mm),
                         fmt::format("must be less than half of the paper's {}mm", shorter));
}

files::Dots dots_of(const files::PointSet& set, const Style& style) {
    const Page page = page_of(set, style, kMillimetresPerInch / kPointsPerInch);
    files::Dots dots{{}, page.scale, page.left, page.height - page.bottom};
    if (style.diameters.empty()) dots.radii.assign(set.points.size(), dot_diameter(set) / 2);
    for (const double diameter : style.diameters) dots.radii.push_back(diameter / 2);
    return dots;
}

void for_each_layer(const files::PointSet& set, const Style& style, const DrawLayer& draw) {
    if (set.layers.empty()) return draw(std::size_t{0}, set, style);
    const std::vector<std::uint8_t> layers = files::layers_of_points(set);
    for (std::size_t k = 0; k < set.layers.size(); ++k) {
        std::vector<Point> points;
        std::vector<double> diameters;
        for (std::size_t i = 0; i < layers.size(); ++i) {
            if (layers[i] != k) continue;
            points.push_back(set.points[i]);
            if (!style.diameters.empty()) diameters.push_back(style.diameters[i]);
        }
        files::PointSet part = set;
        part.points = points;
        Style its_style = style;
        its_style.diameters = diameters;
        draw(k, part, its_style);
    }
}

double dot_diameter(const files::PointSet& set) {
    if (set.radius > 0) return set.radius / 3 * 2;
    // The radius is unknown: dots get the size that they have in a maximal set with as many points.
    const auto count = static_cast<double>(std::max<std::size_t>(set.points.size(), 1));
    const double radius = std::sqrt(kTorusDensity * set.domain.width * (set.domain.height / count));
    return std::min({radius, set.domain.width, set.domain.height}) / 3 * 2;
}

}  // namespace lacuna::drawing
