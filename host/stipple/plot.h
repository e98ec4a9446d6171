// The way of a pen through the dots, strokes or lines of a stippling, and its time.
#pragma once

#include <lacuna/stipple.h>

#include "files/point_files.h"

namespace lacuna::stippling {

// Finds the length of the path, and adds that of strokes to the length in order of admission.
// `dots` has the stippling's points and their layers.
void measure_path(Stippling& made, const files::PointSet& dots);

// Finds how long a plotter takes.
void time_the_plot(Stippling& made, const files::PointSet& dots, const Plotter& plotter,
                   double mm_per_unit);

}  // namespace lacuna::stippling
