// Colours as they are seen: lightness, and two numbers for hue and saturation.
#pragma once

#include <array>

namespace lacuna::pictures {

// Oklab (Ottosson 2020): lightness, how red rather than green, how yellow rather than blue. The
// same to the last bit on every machine.
using Perceived = std::array<double, 3>;

struct Seen {
    Perceived colour{};
    // By how much each changes with red, green and blue light.
    std::array<Perceived, 3> by_light{};
};

// `light`: red, green and blue, linear, 0 to 1.
Seen seen(const std::array<double, 3>& light);

}  // namespace lacuna::pictures
