// The plot sheet: a set's points, its periodogram, radial power and anisotropy on one page.
#pragma once

#include <lacuna/lacuna.h>

#include <span>
#include <string>

#include "analysis/analyse.h"
#include "drawing/medium.h"
#include "files/point_files.h"

namespace lacuna::analysis {

// The bytes of an svg, pdf or png file. `points` are those of the set that is shown, the first of
// several. The same analysis gives the same bytes on every call, where the same fonts are installed
// (DejaVu Sans, or what fontconfig takes for it). Throws files::FileError if it cannot be drawn.
std::string draw_sheet(const Analysis& analysis, std::span<const Point> points,
                       drawing::Medium medium);

}  // namespace lacuna::analysis
