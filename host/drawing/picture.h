// Point sets as pictures: black dots on white.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "drawing/medium.h"
#include "files/point_files.h"

namespace lacuna::drawing {

inline constexpr double kMillimetresPerInch = 25.4;
inline constexpr double kPointsPerInch = 72;  // as PostScript and PDF have them

// A sheet of paper. The domain is drawn as large as the margins allow, in the middle.
struct Sheet {
    double width_mm;
    double height_mm;
    double margin_mm = 0;
};

// What a picture looks like, beyond what the set tells.
struct Style {
    std::optional<Sheet> sheet;    // none: the domain alone, 512 points along its longer side
    double pixels_per_inch = 144;  // of png
    std::span<const double> diameters{};  // of each dot, in the domain's units; empty: as
                                          // files::PointSet has it
    // For a plotter's pen: dots are drawn in their order, not size by size, and an svg has no
    // background, which a plotter would take for a shape.
    bool for_a_pen = false;
};

// How large a unit of the domain becomes.
double millimetres_per_unit(const files::PointSet& set, const Style& style);

// The dots as they are drawn, for files that have columns for them.
files::Dots dots_of(const files::PointSet& set, const Style& style);

// The bytes of an svg, pdf or png file: encode() for these three formats. With a sheet, an svg is
// in mm and has no background either. Dots are lines of at most 0.01 mm or pt with round caps in an
// svg and filled circles in a pdf; a png tells its resolution. The same set gives the same bytes on
// every call. Throws files::FileError with cairo's reason.
std::string draw(const files::PointSet& set, Medium medium, const Style& style = {});

}  // namespace lacuna::drawing
