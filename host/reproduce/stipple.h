// Stipples of the image given, as figures 7 and 8 have them: dots of one size.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <span>

#include "reproduce/sets.h"

namespace lacuna::reproduce {

inline constexpr std::uint64_t kDots = 20'000;

// The sides of the image's domain: as many units as pixels over its longer side, which is 1.
struct Sides {
    double width;
    double height;
};
Sides sides_of(const Field& image);

// One set of so many dots; m = 30 as in the paper's experiments.
Sets stipple(const Field& image, std::uint64_t dots, Metric metric, Work& work, double cost);

// How far dots are from the image's tones: the image in squares, `across` of them along its longer
// side, half the sum over them of |share of the dots - share of the importance|. It is the share of
// dots that would have to move to another square.
double tone_error(const Field& image, std::span<const Point> dots, std::uint32_t across);

}  // namespace lacuna::reproduce
