// Canvases that write SVG themselves: see canvas.h.
#pragma once

#include <memory>

#include "drawing/canvas.h"

namespace lacuna::drawing {

// Not by cairo, whose SVG numbers the surfaces of the whole process, so that a second call gives
// other bytes, and whose text is outlines that cannot be searched or edited.
std::unique_ptr<Canvas> make_svg_canvas(double width, double height);

// The bytes of the image as a PNG file. Throws files::FileError.
std::string png_of(const Image& image);

}  // namespace lacuna::drawing
