// Draws the shapes, pixel by pixel.
#include "reproduce/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace lacuna::reproduce {
namespace {

struct Bar {
    double left;
    double right;
};
constexpr std::array kBars{Bar{0.1, 0.22}, Bar{0.36, 0.42}, Bar{0.56, 0.59}, Bar{0.73, 0.745}};

double importance_at(double x, double y, double background) {
    if (std::hypot(x - 0.3, y - 0.68) < 0.2) return 1;
    const bool in_a_bar = std::any_of(
        kBars.begin(), kBars.end(), [=](const Bar& bar) { return x > bar.left && x < bar.right; });
    if (y > 0.08 && y < 0.4 && in_a_bar) return 1;
    // The ramp: logarithmic, from the background's importance at the left to 1 at the right.
    constexpr double kLeft = 0.62, kRight = 0.92;
    if (x > kLeft && x < kRight && y > 0.52 && y < 0.88)
        return std::pow(background, (kRight - x) / (kRight - kLeft));
    return background;
}

}  // namespace

Field shapes(double background) {
    constexpr std::uint32_t kSide = 512;
    Field field{kSide, kSide, {}};
    for (std::uint32_t row = 0; row < kSide; ++row)
        for (std::uint32_t column = 0; column < kSide; ++column)
            field.importance.push_back(
                importance_at((column + 0.5) / kSide, 1 - (row + 0.5) / kSide, background));
    return field;
}

}  // namespace lacuna::reproduce
