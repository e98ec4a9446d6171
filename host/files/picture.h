// Point sets as pictures: black dots on white.
#pragma once

#include <string>

#include "files/point_files.h"

namespace lacuna::files {

// The bytes of an svg, pdf or png file: encode() for these three formats. The same set gives the
// same bytes on every call. Throws FileError with cairo's reason.
std::string draw(const PointSet& set, Format format);

}  // namespace lacuna::files
