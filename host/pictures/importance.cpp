// Turns a picture's luminance into importance.
#include "pictures/importance.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "base/polling.h"
#include "base/power.h"
#include "files/parse.h"

namespace lacuna::pictures {
namespace {

double stretched(double brightness, const Levels& levels) {
    return std::clamp((brightness - levels.black) / (levels.white - levels.black), 0.0, 1.0);
}

// Finds paper: the most frequent lightness in the lighter half of the levels, if it is near the
// lightest there is, and over half of the pixels are about as light. It varies about as much to the
// dark as to the light, so twice as far below its peak as the lightest are above it is its edge,
// and all that is lighter becomes white. With `invert` paper is what is darkest.
Levels with_white_paper(const Image& image, bool invert, const Levels& levels) {
    constexpr std::size_t kBins = 64;
    constexpr double kWidest = 0.15;  // from the peak to the lightest
    std::array<std::size_t, kBins> pixels{};
    for_each_polled(image.luminance.size(), ask, [&](std::size_t i) {
        const double lightness = stretched(image.luminance[i] / image.white, levels);
        const double turned = invert ? 1 - lightness : lightness;
        ++pixels[std::min(static_cast<std::size_t>(turned * kBins), kBins - 1)];
    });
    auto* const half = pixels.begin() + kBins / 2;
    const auto peak = std::max_element(half, pixels.end()) - pixels.begin();
    const double above = 1 - (static_cast<double>(peak) + 0.5) / kBins;
    if (above > kWidest) return levels;
    const double edge = 1 - 3 * std::max(above, 1.0 / kBins);
    const auto* const first = pixels.begin() + static_cast<std::ptrdiff_t>(edge * kBins) + 1;
    const auto of_paper = std::accumulate(first, pixels.cend(), std::size_t{0});
    if (2 * of_paper <= image.luminance.size()) return levels;
    const double range = levels.white - levels.black;
    if (invert) return {levels.white - edge * range, levels.white};
    return {levels.black, levels.black + edge * range};
}

// The darkest half percent of the pixels becomes black, and the brightest half percent or paper
// white. A picture in which both levels are equal is not stretched.
Levels auto_levels_of(const Image& image, bool invert) {
    constexpr std::size_t kOneIn = 200;
    std::vector<double> values = image.luminance;
    const std::size_t beyond = (values.size() - 1) / kOneIn;
    const auto at = [&](std::size_t index) {
        const auto place = values.begin() + static_cast<std::ptrdiff_t>(index);
        std::nth_element(values.begin(), place, values.end(), [](double a, double b) {
            ask_after();
            return a < b;
        });
        return *place / image.white;
    };
    const Levels levels{at(beyond), at(values.size() - 1 - beyond)};
    return levels.black < levels.white ? with_white_paper(image, invert, levels) : Levels{0, 1};
}

// x^(1/5) for x in [0.0003, 1], by Newton's method: the same on every machine, unlike std::pow.
double fifth_root(double x) {
    double root = 0.5 + 0.5 * x;
    for (int i = 0; i < 8; ++i) {
        const double square = root * root;
        root = 0.8 * root + 0.2 * x / (square * square);
    }
    return root;
}

}  // namespace

void check(const Importance& options) {
    if (!(options.black >= 0 && options.black < 1))
        throw BadRequest("black", fmt::format("{}", options.black),
                         "must be at least 0 and under 1, the picture's white");
    if (!(options.white > options.black && options.white <= 1))
        throw BadRequest("white", fmt::format("{}", options.white),
                         fmt::format("must be over --black, {}, and at most 1, the picture's white",
                                     options.black));
    if (options.auto_levels && (options.black != 0 || options.white != 1))
        throw BadRequest("auto-levels", "with --black or --white", "chooses both");
    if (!(options.gamma > 0) || !std::isfinite(options.gamma))
        throw BadRequest("gamma", fmt::format("{}", options.gamma),
                         "must be a finite number over 0");
    if (!(options.min_importance >= 0 && options.min_importance <= 1))
        throw BadRequest("min-importance", fmt::format("{}", options.min_importance),
                         "must be 0 to 1");
    if (options.turn % 90 != 0 || options.turn >= 360)
        throw BadRequest("turn", fmt::format("{}", options.turn), "must be 0, 90, 180 or 270");
    constexpr std::uint32_t kMostSharpen = 1000;
    constexpr double kMostAmount = 100;
    if (options.sharpen > kMostSharpen)
        throw BadRequest("sharpen", fmt::format("{}", options.sharpen),
                         fmt::format("must be at most {} pixels", kMostSharpen));
    if (!(options.sharpen_amount > 0 && options.sharpen_amount <= kMostAmount))
        throw BadRequest("sharpen", fmt::format("{}:{}", options.sharpen, options.sharpen_amount),
                         fmt::format("the amount must be over 0 and at most {}", kMostAmount));
    constexpr double kMostAlong = 1000;
    if (!(options.along >= 1 && options.along <= kMostAlong))
        throw BadRequest("along", fmt::format("{}", options.along),
                         fmt::format("must be 1 to {}", kMostAlong));
}

Levels levels_of(const Image& image, const Importance& options) {
    return options.auto_levels ? auto_levels_of(image, options.invert)
                               : Levels{options.black, options.white};
}

void to_darkness(Image& image, const Levels& levels, bool invert) {
    const bool stretches = levels.black != 0 || levels.white != 1;
    for_each_polled(image.luminance.size(), ask, [&](std::size_t i) {
        double brightness = image.luminance[i] / image.white;
        if (stretches) brightness = stretched(brightness, levels);
        image.luminance[i] = invert ? brightness : 1 - brightness;
    });
}

// x^2.4 is x^2 times the square of x^(1/5).
double light_of(double encoded) {
    if (encoded <= 0.04045) return encoded / 12.92;
    const double x = (encoded + 0.055) / 1.055;
    const double root = fifth_root(x);
    return x * x * root * root;
}

bool is_zero_all_over(const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [](double value) { return value == 0; });
}

void refuse_blank(const std::string& name, bool invert) {
    files::refuse(
        name, invert ? "black all over, so that with --invert no sample is wanted anywhere: must "
                       "be brighter somewhere, or give a --min-importance over 0"
                     : "white all over, so that no sample is wanted anywhere: must be darker "
                       "somewhere, or give --invert or a --min-importance over 0, or, if it is "
                       "transparent, --background black");
}

void apply_gamma_and_least(std::vector<double>& values, const std::string& name,
                           const Importance& options) {
    if (is_zero_all_over(values) && options.min_importance == 0) return;
    for_each_polled(values.size(), ask, [&](std::size_t i) {
        if (options.gamma != 1) values[i] = power(values[i], options.gamma);
        values[i] = std::max(options.min_importance, values[i]);
    });
    if (is_zero_all_over(values))
        throw BadRequest("gamma", fmt::format("{}", options.gamma),
                         fmt::format("must be smaller: it rounds all importance in {} to 0", name));
}

namespace {

// Puts the darkness of light in place of that of a picture's numbers: Tone::light. Most numbers
// come again, and decoding one takes as long as finding several.
void to_darkness_of_light(std::vector<double>& darkness, bool invert) {
    constexpr unsigned kBits = 12;
    struct Known {
        double number = -1;
        double light = 0;
    };
    std::vector<Known> known(std::size_t{1} << kBits);
    for_each_polled(darkness.size(), ask, [&](std::size_t i) {
        const double number = invert ? darkness[i] : 1 - darkness[i];
        const std::uint64_t hash = std::bit_cast<std::uint64_t>(number) * 0x9e3779b97f4a7c15U;
        auto& [decoded, light] = known[hash >> (64U - kBits)];
        if (decoded != number) {
            decoded = number;
            light = light_of(number);
        }
        darkness[i] = invert ? light : 1 - light;
    });
}

}  // namespace

Field importance_of(Image image, const Importance& options) {
    check(options);
    cut(image, options);
    sharpen(image, options);
    to_darkness(image, levels_of(image, options), options.invert);
    std::vector<double>& values = image.luminance;
    if (options.min_importance == 0 && is_zero_all_over(values))
        refuse_blank(image.name, options.invert);
    std::vector<Stretch> stretches;
    if (options.along != 1)
        stretches = stretches_along(values, image.columns, image.rows, options.along);
    if (options.light && !image.is_linear) to_darkness_of_light(values, options.invert);
    apply_gamma_and_least(values, image.name, options);
    return {image.columns, image.rows, std::move(values), std::move(stretches)};
}

}  // namespace lacuna::pictures
