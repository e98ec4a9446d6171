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
    for_each_polled(blurred.size(), ask, [&](std::size_t i) {
        const double edge = image.luminance[i] - blurred[i];
        if (std::abs(edge) < least) return;
        image.luminance[i] =
            std::clamp(image.luminance[i] + options.sharpen_amount * edge, 0.0, image.white);
    });
}

}  // namespace lacuna::pictures
