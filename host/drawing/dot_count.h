// How many dots suit a picture, on a screen or drawn by a pen.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <optional>

#include "drawing/picture.h"

namespace lacuna::drawing {

// The mean importance, 0 to 1.
double darkness_of(const Field& field);

// One to 16 pixels of black, a grey pixel counting as much as it is dark, and the longer side as
// 512 to 2048 pixels. 1 to kMostDots. `width` and `height` are the picture's shape, the longer 1.
constexpr double kMostDots = 1e6;
std::uint64_t dot_count(const Field& field, double width, double height);

// The same where no size of the dots is given; with their diameter in mm, as many as it takes for
// their areas to sum to the picture's darkness.
std::uint64_t default_count(const Field& field, double width, double height,
                            std::optional<double> dot_size_mm, const Style& style);

}  // namespace lacuna::drawing
