// Point sets as svg, without cairo, which the web page does not have.
#pragma once

#include <string>

#include "drawing/picture.h"

namespace lacuna::drawing {

// The bytes of the file: draw() for svg.
std::string draw_svg(const files::PointSet& set, const Style& style);

// The texts about a set's origin in svg and pdf.
std::string seed_text(const files::Origin& origin);
std::string program_text(const files::Origin& origin);

}  // namespace lacuna::drawing
