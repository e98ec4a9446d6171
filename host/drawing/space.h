// Files and pictures of sets in space.
#pragma once

#include <string>

#include "files/space_files.h"

namespace lacuna::drawing {

// The bytes of a file in the given format: what files::encode() writes, or a png of three views
// side by side: from the right, from the front and from above, which is where x, -y and z point. On
// a mesh hidden points are left out; in a volume points fade with their depth. Throws what
// files::encode() throws, and FileError.
std::string encode(const files::SetInSpace& set, const files::Format& format);

}  // namespace lacuna::drawing
