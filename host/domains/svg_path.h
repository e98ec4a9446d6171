// The attributes of SVG that draw: path data, lists of points and transforms (SVG 1.1, chapters 7
// and 8).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "domains/outline.h"

namespace lacuna::domains {

// Each returns what is wrong with the text, in words that follow "path 3: ", or nothing.
std::optional<std::string> draw_path(std::string_view data, Outline& outline);
std::optional<std::string> draw_points(std::string_view points, Outline& outline);
std::optional<std::string> read_transform(std::string_view text, Affine& transform);

// By an angle, as in rotate(degrees); exact for quarters.
Affine turned_by(double degrees);

}  // namespace lacuna::domains
