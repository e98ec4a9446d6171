// Turns cairo's images into PNG files that record their resolution.
#pragma once

#include <cairo.h>

#include <string>

namespace lacuna::drawing {

// The bytes of the file, with the chunk pHYs, which cairo does not write. Throws files::FileError
// with cairo's reason.
std::string png_of(cairo_surface_t* image, double pixels_per_inch);

}  // namespace lacuna::drawing
