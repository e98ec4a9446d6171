// Point sets as svg, without cairo, which the web page does not have.
#pragma once

#include <string>

#include "drawing/page.h"
#include "drawing/picture.h"

namespace lacuna::drawing {

// The bytes of the file: draw() for svg.
std::string draw_svg(const files::PointSet& set, const Style& style);

// The texts about a set's origin in svg and pdf.
std::string seed_text(const files::Origin& origin);
std::string program_text(const files::Origin& origin);

// Appends the dots of a set of ellipses, filled: each of two arcs, from one end of its longer axis
// to the other and back.
void append_ovals(std::string& bytes, const files::PointSet& set, const Style& style,
                  const Page& page);
// The same for strokes: lines with round ends.
void append_strokes(std::string& bytes, const files::PointSet& set, const Page& page);
// The same for dots that a pen draws: lines of arcs.
void append_pen_dots(std::string& bytes, const files::PointSet& set, const Style& style,
                     const Page& page);

}  // namespace lacuna::drawing
