// Colours that inks cannot make keep their lightness first, then their hue.
#include <gtest/gtest.h>
#include <lacuna/pictures.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "pictures/importance.h"
#include "pictures/perceived.h"
#include "pictures/separator.h"

namespace lacuna::pictures {
namespace gamut_test {

// Oklab's lightness, saturation, and hue in degrees (Ottosson 2020), by another way to write it.
struct Lch {
    double lightness;
    double saturation;
    double hue;
};

double light(double number) {
    return number <= 0.04045 ? number / 12.92 : std::pow((number + 0.055) / 1.055, 2.4);
}

Lch lch(const Channels& numbers) {
    const double r = light(numbers[0]), g = light(numbers[1]), b = light(numbers[2]);
    const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    const double a = 1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s;
    const double c = 0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s;
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s, std::hypot(a, c),
            std::atan2(c, a) * 180 / std::numbers::pi};
}

double degrees_between(double a, double b) {
    return std::abs(std::remainder(a - b, 360));
}

// What inks print for a colour.
struct Print {
    std::vector<double> amounts;
    Channels colour;
};

Print print_of(const Channels& numbers, const std::string& inks) {
    Separator separator(inks_of(inks), kBlackInk, kWhitePaper, false);
    const std::span<const double> amounts = separator.amounts(numbers);
    return {{amounts.begin(), amounts.end()}, separator.printed(amounts)};
}

double largest_difference(const Channels& a, const Channels& b) {
    double most = 0;
    for (std::size_t c = 0; c < a.size(); ++c) most = std::max(most, std::abs(a[c] - b[c]));
    return most;
}

TEST(ColoursAsSeen, AreOklabAndTheirSlopesAreRight) {
    for (const Channels& one : {Channels{0.8, 0.1, 0.3}, Channels{0.2, 0.9, 0.9}}) {
        const auto [colour, by_light] = seen(one);
        for (std::size_t c = 0; c < 3; ++c) {
            Channels more = one;
            more[c] += 1e-5;
            for (std::size_t i = 0; i < 3; ++i)
                EXPECT_NEAR((seen(more).colour[i] - colour[i]) / 1e-5, by_light[i][c], 1e-3);
        }
    }
    // Its lightness is near the cube root of luminance, which white has 1 of.
    EXPECT_NEAR(seen({1, 1, 1}).colour[0], 1, 1e-3);
    EXPECT_NEAR(seen({0.2, 0.2, 0.2}).colour[0], std::cbrt(0.2), 2e-3);
}

// By plain least squares lightness was 0.25 off at most and 0.05 on average, and the saturation
// times the turn of the hue 0.03 on average.
TEST(ColoursThatCmykCannotMake, KeepTheirLightnessThenTheirHue) {
    constexpr int kSteps = 8;
    const double black = lch({0x1d / 255.0, 0x1d / 255.0, 0x1b / 255.0}).lightness;
    double turned = 0;
    int made = 0, others = 0;
    for (int i = 0; i < kSteps * kSteps * kSteps; ++i) {
        const Channels wanted{i % kSteps / 7.0, i / kSteps % kSteps / 7.0,
                              i / kSteps / kSteps / 7.0};
        const Channels printed = print_of(wanted, "cmyk").colour;
        const Lch is = lch(printed), was = lch(wanted);
        if (was.lightness > 2 * black) {
            EXPECT_NEAR(is.lightness, was.lightness, 0.03) << i;
        }
        if (largest_difference(printed, wanted) < 0.03) {
            ++made;
            continue;
        }
        ++others;
        const double angle = degrees_between(is.hue, was.hue) * std::numbers::pi / 180;
        turned += 2 * std::sqrt(is.saturation * was.saturation) * std::sin(angle / 2);
    }
    EXPECT_GT(made, 200);
    EXPECT_GT(others, 200);
    EXPECT_LT(turned / others, 0.018);
}

TEST(ColoursThatCmykCannotMake, AreStillOfTheirHue) {
    for (const Channels& wanted : {Channels{0, 0, 1}, Channels{0.2, 0.1, 0.9}, Channels{1, 0, 0.2},
                                   Channels{0, 0.6, 0.2}, Channels{0.5, 0, 0.9}}) {
        const Lch is = lch(print_of(wanted, "cmyk").colour), was = lch(wanted);
        EXPECT_NEAR(is.lightness, was.lightness, 0.02) << was.hue;
        EXPECT_LT(degrees_between(is.hue, was.hue), 12) << was.hue;
        EXPECT_GT(is.saturation, 0.3 * was.saturation) << was.hue;
    }
}

// Few inks show what they can: lightness, and saturation where it is not of another hue.
TEST(ColoursOfFewInks, KeepTheirLightnessAndHaveNoInkOfAnotherHue) {
    const Channels skin{0.87, 0.68, 0.56}, blue{0.1, 0.2, 0.8}, red{0.8, 0.15, 0.2},
        yellow{0.95, 0.9, 0.1};
    for (const Channels& wanted : {skin, blue, red, yellow})
        EXPECT_NEAR(lch(print_of(wanted, "black,red").colour).lightness, lch(wanted).lightness,
                    0.01);
    EXPECT_GT(print_of(skin, "black,red").amounts[1], 0.05);
    EXPECT_GT(print_of(red, "black,red").amounts[1], 0.7);
    EXPECT_EQ(print_of(blue, "black,red").amounts[1], 0);
    EXPECT_EQ(print_of(yellow, "black,red").amounts[1], 0);
    EXPECT_GT(print_of(blue, "red,blue").amounts[1], 0.7);
}

}  // namespace gamut_test
}  // namespace lacuna::pictures
