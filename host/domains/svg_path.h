// Reads the attributes that draw in SVG: path data, lists of points and transforms (SVG 1.1,
// chapters 7 and 8).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "domains/outline.h"

namespace lacuna::domains {

// Each returns an error message that can follow "path 3: ", or nothing if the text is right.
std::optional<std::string> draw_path(std::string_view data, Outline& outline);
std::optional<std::string> draw_points(std::string_view points, Outline& outline);
std::optional<std::string> read_transform(std::string_view text, Affine& transform);
// The property `transform` of a style, in lower case: with units.
std::optional<std::string> read_css_transform(std::string_view text, Affine& transform);

// A rotation by an angle, as in rotate(degrees); exact for multiples of 90.
Affine turned_by(double degrees);

}  // namespace lacuna::domains
