// The options of stipple(), checked, and what follows from them.
#pragma once

#include <lacuna/stipple.h>

namespace lacuna::stippling {

// A stippling without dots: its request has the mode and the metric. Throws BadRequest for options
// that stipple() refuses with every picture.
Stippling settled(const StippleOptions& options);

// The width of the widest pen in mm; 0 without pens.
double widest_pen(const StippleOptions& options);

}  // namespace lacuna::stippling
