// Point sets as pictures: black dots on white.
#pragma once

#include <lacuna/stipple.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "files/medium.h"
#include "files/point_files.h"

namespace lacuna::drawing {

using files::Medium;

inline constexpr double kMillimetresPerInch = 25.4;
inline constexpr double kPointsPerInch = 72;  // in PostScript and PDF

// The paper on which a domain of this shape is drawn: turned to landscape if the domain is wider
// than high and the paper may be turned.
Paper turned(const Paper& paper, const Domain& domain);

// Throws BadRequest if the margins leave no room.
void check(const Paper& paper);

// Options of a picture that do not depend on the set.
struct Style {
    std::optional<Paper> sheet;  // none: the page is the domain, its longer side 512 points
    Colour paper_colour = kWhitePaper;
    std::optional<double> pixels_per_inch{};  // only for png; unset: resolution_of() chooses
    std::span<const double> diameters{};  // of each dot, in the domain's units; empty: all equal
    // Ellipses are strokes of a pen of 2 b, 2 a long with their round ends.
    bool are_strokes = false;
    // Over 0: the width of the pen that draws dots that are wider, as spirals or circles.
    double pen_mm = 0;
    bool circles = false;
    // Over 0: a line through the dots of each layer, in place of dots. It is as wide as the ink's
    // pen or, without one, as this, in the domain's units.
    double line_width = 0;
    // For a plotter's pen. Dots are drawn in their order, not size by size; an svg has no
    // background, because a plotter would take it for a shape.
    bool for_a_pen = false;
    // What a plotter does for each layer, which an svg of layers says; empty: not known.
    std::vector<LayerPlot> layer_plots{};
};

// A set with the style in which it is drawn. It refers to what it was made of.
struct Shown {
    files::PointSet set;
    Style style;
};
// The dots of a picture, as files show them.
Shown shown(const Stippling& stippling);

// The length of a unit of the domain on the page.
double millimetres_per_unit(const files::PointSet& set, const Style& style);

// Pixels per inch of a png: as the style says, or 144, but so many that dots are 4 pixels apart on
// average, as far as the longer side stays within 8192 pixels.
double resolution_of(const files::PointSet& set, const Style& style);

// The dots' sizes and positions on the page, for file formats with columns for them.
files::Dots dots_of(const files::PointSet& set, const Style& style);

// The bytes of an svg, pdf or png file: encode() for these formats. In an svg, dots are lines of at
// most 0.01 mm or pt with round caps; in a pdf they are filled circles. With a sheet, an svg is in
// mm and has no background. A png records its resolution. The same set gives the same bytes on
// every call. Throws files::FileError with cairo's reason.
std::string draw(const files::PointSet& set, Medium medium, const Style& style = {});

// The bytes of a file in the given format: pictures are drawn in the style, and other formats have
// what files::encode() writes, and throw what it throws.
std::string encode(const files::PointSet& set, const files::Format& format, const Style& style);

}  // namespace lacuna::drawing
