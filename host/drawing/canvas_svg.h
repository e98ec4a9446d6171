// A canvas that writes SVG without cairo: see canvas.h.
#pragma once

#include <memory>

#include "drawing/canvas.h"

namespace lacuna::drawing {

// Cairo is not used for two reasons. It numbers the surfaces of the whole process, so a second call
// gives other bytes; and its text is outlines, which nobody can search or edit.
std::unique_ptr<Canvas> make_svg_canvas(double width, double height);

// The bytes of the image as a PNG file. Throws files::FileError.
std::string png_of(const Image& image);

}  // namespace lacuna::drawing
