// The plot sheet: points, periodogram, radial power and anisotropy of a set on one page.
#pragma once

#include <lacuna/lacuna.h>

#include <span>
#include <string>

#include "analysis/analyse.h"
#include "files/medium.h"
#include "files/point_files.h"

namespace lacuna::analysis {

// The bytes of an svg, pdf or png file. `points` are the points that are shown; of several sets,
// the first. The same analysis gives the same bytes on every call if the same fonts are installed
// (DejaVu Sans, or fontconfig's substitute). Throws files::FileError if it cannot be drawn.
std::string draw_sheet(const Analysis& analysis, std::span<const Point> points,
                       files::Medium medium);

}  // namespace lacuna::analysis
