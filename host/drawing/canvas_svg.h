// A canvas that writes SVG without cairo: see canvas.h.
#pragma once

#include <memory>

#include "drawing/canvas.h"

namespace lacuna::drawing {

// Cairo is not used for two reasons. It numbers the surfaces of the whole process, so a second call
// gives other bytes; and its text is outlines, which nobody can search or edit.
std::unique_ptr<Canvas> make_svg_canvas(double width, double height);

}  // namespace lacuna::drawing
