// The way of a pen through the dots, strokes or lines of a stippling, and its time.
#pragma once

#include <lacuna/stipple.h>

#include "files/point_files.h"

namespace lacuna::stippling {

// Finds the lengths of the layers' paths with their strokes, circles and spirals, adds these to the
// length in order of admission, and finds how long a plotter takes. `dots` has the stippling's
// points and their layers.
void plot(Stippling& made, const files::PointSet& dots, const Plotter& plotter, double mm_per_unit);

}  // namespace lacuna::stippling
