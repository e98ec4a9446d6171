// Importance of a picture's luminance.
#include "pictures/importance.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "files/parse.h"

namespace lacuna::pictures {
namespace {

bool is_zero_all_over(const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [](double value) { return value == 0; });
}

[[noreturn]] void refuse_blank(const Image& image, bool invert) {
    files::refuse(image.name,
                  invert
                      ? "black all over, so that with --invert no sample is wanted anywhere: must "
                        "be brighter somewhere, or give a --min-importance over 0"
                      : "white all over, so that no sample is wanted anywhere: must be darker "
                        "somewhere, or give --invert or a --min-importance over 0");
}

}  // namespace

void check(const Importance& options) {
    if (!(options.gamma > 0) || !std::isfinite(options.gamma))
        throw BadRequest("gamma", fmt::format("{}", options.gamma),
                         "must be a finite number over 0");
    if (!(options.min_importance >= 0 && options.min_importance <= 1))
        throw BadRequest("min-importance", fmt::format("{}", options.min_importance),
                         "must be 0 to 1");
}

Field importance_of(Image image, const Importance& options) {
    check(options);
    std::vector<double>& values = image.luminance;
    for (double& value : values) {
        const double brightness = value / image.white;
        value = options.invert ? brightness : 1 - brightness;
    }
    if (options.min_importance == 0 && is_zero_all_over(values))
        refuse_blank(image, options.invert);
    if (options.gamma != 1)
        for (double& value : values) value = std::pow(value, options.gamma);
    for (double& value : values) value = std::max(options.min_importance, value);
    if (is_zero_all_over(values))
        throw BadRequest(
            "gamma", fmt::format("{}", options.gamma),
            fmt::format("must be smaller: it rounds all importance in {} to 0", image.name));
    return {image.columns, image.rows, std::move(values)};
}

}  // namespace lacuna::pictures
