// The svg among the pictures of point sets, apart from cairo, which pages of the web lack.
#pragma once

#include <string>

#include "drawing/picture.h"

namespace lacuna::drawing {

// The bytes of the file: draw() for an svg.
std::string draw_svg(const files::PointSet& set, const Style& style);

// What svg and pdf tell of a set's origin.
std::string seed_text(const files::Origin& origin);
std::string program_text(const files::Origin& origin);

}  // namespace lacuna::drawing
