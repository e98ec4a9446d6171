// Sharpens a picture by an unsharp mask.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/polling.h"
#include "pictures/blur.h"
#include "pictures/importance.h"

namespace lacuna::pictures {

void sharpen(Image& image, const Importance& options) {
    if (options.sharpen == 0) return;
    std::vector<double> blurred = image.luminance;
    blur(blurred, image.columns, image.rows, options.sharpen);
    // A smaller difference is of rounding: it must not put importance on white.
    const double least = 1e-9 * image.white;
    // On the side of an edge where dots are dense, pixels come at most half of the way to black (to
    // white with `invert`): otherwise dots there would touch, as a line.
    constexpr double kMostOfWay = 0.5;
    for_each_polled(blurred.size(), ask, [&](std::size_t i) {
        double& light = image.luminance[i];
        const double edge = light - blurred[i];
        if (std::abs(edge) < least) return;
        const double lowest = options.invert ? 0 : light - kMostOfWay * light;
        const double highest =
            options.invert ? light + kMostOfWay * (image.white - light) : image.white;
        light = std::clamp(light + options.sharpen_amount * edge, lowest, highest);
    });
}

}  // namespace lacuna::pictures
