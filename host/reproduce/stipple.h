// The given image drawn with dots of one size, as in figures 7 and 8.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <span>

#include "reproduce/sets.h"

namespace lacuna::reproduce {

inline constexpr std::uint64_t kDots = 20'000;

// One set with `dots` dots, and m = 30 as in the paper's experiments.
Sets stipple(const Field& image, std::uint64_t dots, Metric metric, Work& work, double cost);

// The difference between dots and image in tone. The image is cut into squares, `across` of them
// along its longer side. The result is half the sum over all squares of |fraction of the dots -
// fraction of the importance|: the fraction of dots that would have to move to another square.
double tone_error(const Field& image, std::span<const Point> dots, std::uint32_t across);

}  // namespace lacuna::reproduce
