// How long a plotter moves its pen: a model of its speeds and its acceleration.
#pragma once

#include <lacuna/lacuna.h>
#include <lacuna/stipple.h>

#include <span>

#include "drawing/pen_dot.h"

namespace lacuna::pen {

// From standing to standing, straight on.
double seconds_up(const Plotter& plotter, double mm);
double seconds_straight_down(const Plotter& plotter, double mm);
// Along the circle or spiral in which a pen draws a dot, whose lengths are in mm. It goes so slowly
// that it is accelerated sideways no more than it may be along its way.
double seconds_around(const Plotter& plotter, const drawing::PenDot& dot);

// From standing to standing, along a line through these points.
double seconds_down(const Plotter& plotter, std::span<const Point> line, double mm_per_unit);

// The mean time of a segment in a line along a pen path, if segments are this long on average. It
// is 2 to 5 % longer than in lines through the dots of photographs.
double usual_seconds_down(const Plotter& plotter, double mm);

}  // namespace lacuna::pen
