// Oklab, with its derivatives.
#include "pictures/perceived.h"

#include <cstddef>

namespace lacuna::pictures {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

// From linear sRGB to the responses of the eye's cones, and from their cube roots to Oklab.
constexpr Matrix kCones{{{0.4122214708, 0.5363325363, 0.0514459929},
                         {0.2119034982, 0.6806995451, 0.1073969566},
                         {0.0883024619, 0.2817188376, 0.6299787005}}};
constexpr Matrix kOpponents{{{0.2104542553, 0.7936177850, -0.0040720468},
                             {1.9779984951, -2.4285922050, 0.4505937099},
                             {0.0259040371, 0.7827717662, -0.8086757660}}};
// Is added to responses, so that no root has an infinite slope: a tenth of what black ink reflects.
constexpr double kGlare = 1e-3;

// x^(1/3) for x from kGlare to 1 + kGlare, by Newton's method.
double cube_root(double x) {
    double root = 0.4 + 0.6 * x;
    for (int i = 0; i < 7; ++i) root -= (root - x / (root * root)) / 3;
    return root;
}

}  // namespace

Seen seen(const std::array<double, 3>& light) {
    Seen result;
    for (std::size_t cone = 0; cone < 3; ++cone) {
        double response = kGlare;
        for (std::size_t c = 0; c < 3; ++c) response += kCones[cone][c] * light[c];
        const double root = cube_root(response), slope = root / (3 * response);
        for (std::size_t i = 0; i < 3; ++i) {
            result.colour[i] += kOpponents[i][cone] * root;
            for (std::size_t c = 0; c < 3; ++c)
                result.by_light[i][c] += kOpponents[i][cone] * slope * kCones[cone][c];
        }
    }
    return result;
}

}  // namespace lacuna::pictures
