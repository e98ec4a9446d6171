// Colours are separated into inks that give them back, and texts name inks.
#include <gtest/gtest.h>
#include <lacuna/pictures.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "pictures/image.h"
#include "refusal.h"
#include "stipple/dot_size.h"

namespace lacuna::pictures {
namespace separate_test {

using lacuna::tests::refusal_of;
using Numbers = std::array<double, 3>;  // red, green and blue, 0 to 1

Numbers numbers_of(const Colour& colour) {
    return {colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0};
}

// The mean numbers of a sheet on which these amounts of inks are printed as dots.
Numbers printed(const std::vector<Ink>& inks, const std::vector<double>& amounts) {
    constexpr std::uint64_t kDots = 1200;
    constexpr int kSide = 300;  // pixels of the sheet, which wraps
    std::vector<Field> fields;
    for (const double amount : amounts) fields.push_back({1, 1, {amount}});
    const std::vector<std::uint64_t> counts = dots_by_ink(kDots, fields);
    std::vector<InkPart> parts;
    for (std::size_t k = 0; k < inks.size(); ++k)
        if (counts[k] != 0) parts.push_back({&fields[k], counts[k]});
    RelaxOptions options;
    options.domain.boundary = Boundary::torus;
    const std::vector<Point> dots = place_inks(parts, 0, options).points;

    std::vector<Numbers> sheet(std::size_t{kSide} * kSide, {1, 1, 1});
    std::size_t first = 0;
    for (std::size_t k = 0; k < inks.size(); ++k) {
        if (counts[k] == 0) continue;
        const auto its = std::span(dots).subspan(first, counts[k]);
        first += counts[k];
        const double radius =
            stippling::dot_diameters(its, fields[k], {1, 1}, stippling::Spread::even)[0] / 2 *
            kSide;
        std::vector<bool> covered(sheet.size());
        for (const Point& dot : its) {
            const double x = dot.x * kSide;
            const double y = dot.y * kSide;
            for (int row = static_cast<int>(y - radius) - 1; row <= y + radius; ++row)
                for (int column = static_cast<int>(x - radius) - 1; column <= x + radius; ++column)
                    if (std::hypot(column + 0.5 - x, row + 0.5 - y) <= radius)
                        covered[static_cast<std::size_t>((row + kSide) % kSide * kSide +
                                                         (column + kSide) % kSide)] = true;
        }
        for (std::size_t i = 0; i < sheet.size(); ++i)
            for (std::size_t c = 0; covered[i] && c < 3; ++c)
                sheet[i][c] *= numbers_of(inks[k].colour)[c];
    }
    Numbers mean{};
    for (const Numbers& spot : sheet)
        for (std::size_t c = 0; c < 3; ++c) mean[c] += spot[c] / static_cast<double>(sheet.size());
    return mean;
}

// A picture of one pixel, with 16 bits a channel.
std::string ppm_of(const Numbers& numbers) {
    std::string text = "P3 1 1 65535";
    for (const double one : numbers) text += ' ' + std::to_string(std::lround(one * 65535));
    return text;
}

std::vector<double> amounts_of(const std::string& bytes, const std::vector<Ink>& inks,
                               double black_ink = kBlackInk, const Tone& tone = {}) {
    std::vector<double> amounts;
    for (const Field& field : separate({bytes, "file"}, inks, tone, black_ink))
        amounts.push_back(field.importance.at(0));
    return amounts;
}

void expect_near(const std::vector<double>& amounts, const std::vector<double>& expected,
                 double tolerance) {
    ASSERT_EQ(amounts.size(), expected.size());
    for (std::size_t k = 0; k < amounts.size(); ++k)
        EXPECT_NEAR(amounts[k], expected[k], tolerance) << "ink " << k;
}

TEST(Inks, PrintTheColourOfThePicture) {
    for (const char* text : {"cmyk", "#0083b8,#d6006d,#ffd500,#1b1b1b"})
        for (const Numbers& wanted :
             {Numbers{0.5, 0.5, 0.5}, Numbers{0.25, 0.35, 0.5}, Numbers{0.6, 0.4, 0.25},
              Numbers{0.8, 0.7, 0.6}, Numbers{0.2, 0.2, 0.22}, Numbers{0.45, 0.25, 0.2},
              Numbers{0.25, 0.25, 0.25}, Numbers{0.13, 0.13, 0.13}})
            for (const double black_ink : {0.0, 0.5, 0.8, 1.0}) {
                const std::vector<Ink> inks = inks_of(text);
                const Numbers got = printed(inks, amounts_of(ppm_of(wanted), inks, black_ink));
                for (std::size_t c = 0; c < wanted.size(); ++c)
                    EXPECT_NEAR(got[c], wanted[c], 0.04)
                        << text << ", " << wanted[0] << " " << wanted[1] << " " << wanted[2]
                        << ", black ink " << black_ink << ", channel " << c;
            }
}

TEST(Inks, OfTheirOwnColoursAreAlone) {
    for (const char* text : {"cmyk", "red,green,blue"}) {
        const std::vector<Ink> inks = inks_of(text);
        for (std::size_t k = 0; k < inks.size(); ++k) {
            std::vector<double> alone(inks.size(), 0);
            alone[k] = 1;
            expect_near(amounts_of(ppm_of(numbers_of(inks[k].colour)), inks, 1), alone, 0.04);
        }
    }
}

TEST(Inks, OfGreyAreBlackOrOthersAsBlackInkSays) {
    const std::vector<Ink> inks = inks_of("#00ffff,#ff00ff,#ffff00,#000000");
    const std::string grey = ppm_of({0.5, 0.5, 0.5});
    expect_near(amounts_of(grey, inks, 1), {0, 0, 0, 0.5}, 0.001);
    expect_near(amounts_of(grey, inks, 0), {0.5, 0.5, 0.5, 0}, 0.001);
    const std::vector<double> half = amounts_of(grey, inks, 0.5);
    EXPECT_NEAR(half[3], 0.25, 0.001);
    EXPECT_NEAR(half[0], half[2], 0.001);
    EXPECT_GT(half[0], 0.25);  // without overlap it would be 0.25
}

// Grey, or a colour, from the lightest to black in 256 steps.
std::string to_black(const Numbers& lightest) {
    std::string text = "P3 256 1 65025";
    for (int grey = 255; grey >= 0; --grey)
        for (const double one : lightest)
            text += ' ' + std::to_string(std::lround(grey * one * 255));
    return text;
}

TEST(BlackInk, GrowsStepByStepAsThePictureGetsDarker) {
    for (const char* text : {"cmyk", "#0083b8,#d6006d,#ffd500,#1b1b1b", "red,black", "black"})
        for (const double black_ink : {0.0, 0.1, 0.3, 0.5, 0.8, 1.0}) {
            SCOPED_TRACE(std::string(text) + ", black ink " + std::to_string(black_ink));
            const std::vector<Ink> inks = inks_of(text);
            const std::vector<Field> fields =
                separate({to_black({1, 1, 1}), "file"}, inks, {}, black_ink);
            const auto is_black = [](const Ink& ink) { return ink.colour[0] < 0x20; };
            const std::size_t black = static_cast<std::size_t>(
                std::find_if(inks.begin() + (inks.size() > 3 ? 3 : 0), inks.end(), is_black) -
                inks.begin());
            double all_on_black = 0;
            for (std::size_t k = 0; k < inks.size(); ++k) {
                const std::vector<double>& amounts = fields[k].importance;
                for (std::size_t i = 1; i < amounts.size(); ++i) {
                    const double step = amounts[i] - amounts[i - 1];
                    ASSERT_LT(std::abs(step), 0.02) << "ink " << k << ", grey " << 255 - i;
                    ASSERT_TRUE(k != black || step > -1e-3) << "grey " << 255 - i;
                }
                all_on_black += amounts.back();
            }
            EXPECT_NEAR(fields[black].importance.back(), 1, 1e-3);
            EXPECT_NEAR(all_on_black, 1, 0.01);
        }
}

TEST(BlackInk, GrowsInDarkColoursToo) {
    for (const Numbers& lightest :
         {Numbers{1, 0, 0}, Numbers{0, 1, 0}, Numbers{0, 0, 1}, Numbers{1, 1, 0}, Numbers{0, 1, 1},
          Numbers{1, 0, 1}, Numbers{1, 0.6, 0.4}}) {
        const std::vector<Field> fields =
            separate({to_black(lightest), "file"}, inks_of("cmyk"), {}, kBlackInk);
        const std::vector<double>& black = fields[3].importance;
        for (std::size_t i = 1; i < black.size(); ++i)
            ASSERT_LT(std::abs(black[i] - black[i - 1]), 0.2)
                << lightest[0] << " " << lightest[1] << " " << lightest[2] << ", " << 255 - i;
        EXPECT_NEAR(black.back(), 1, 1e-3);
    }
}

TEST(Inks, AreNotNeededOnWhite) {
    const std::vector<Ink> inks = inks_of("cmyk");
    const std::string white_and_black = "P3 2 1 1 1 1 1 0 0 0";
    for (const Field& field : separate({white_and_black, "file"}, inks))
        EXPECT_EQ(field.importance.at(0), 0);
    EXPECT_THROW(separate({"P3 1 1 1 1 1 1", "file"}, inks), FileError);
    EXPECT_EQ(amounts_of("P3 1 1 1 1 1 1", inks, 1, {.min_importance = 0.25}),
              (std::vector<double>(4, 0.25)));
}

TEST(Inks, FollowTheTone) {
    const std::vector<Ink> inks = inks_of("#00ffff,#ff00ff,#ffff00");
    const auto amounts = [&](const Tone& tone) {
        return amounts_of("P3 1 1 100 100 50 20", inks, 0, tone);
    };
    expect_near(amounts({}), {0, 0.5, 0.8}, 0.001);
    expect_near(amounts({.invert = true}), {1, 0.5, 0.2}, 0.001);
    expect_near(amounts({.black = 0.2, .white = 0.5}), {0, 0, 1}, 0.001);
    expect_near(amounts({.gamma = 2}), {0, 0.25, 0.64}, 0.001);
    // IEC 61966-2-1.
    expect_near(amounts({.light = true}), {0, 1 - 0.21404, 1 - 0.03310}, 0.001);
}

TEST(Channels, AreReadAsTheyAreStored) {
    const Colours colours = decode_colours("P3 2 1 255 255 0 51 0 102 255", "file");
    EXPECT_EQ(colours.red.luminance, (std::vector<double>{1, 0}));
    EXPECT_EQ(colours.green.luminance, (std::vector<double>{0, 0.4}));
    EXPECT_EQ(colours.blue.luminance, (std::vector<double>{0.2, 1}));
    const Colours grey = decode_colours("P2 1 1 4 3", "file");
    EXPECT_EQ(grey.red.luminance, grey.blue.luminance);
}

TEST(InkNames, AreReadFromText) {
    const std::vector<Ink> cmyk = inks_of("cmyk");
    ASSERT_EQ(cmyk.size(), 4U);
    EXPECT_EQ(cmyk[3].name, "black");
    EXPECT_EQ(inks_of("red,sea=#0083B8,#ffd500"),
              (std::vector<Ink>{{"red", {0xe0, 0x10, 0x20}},
                                {"sea", {0x00, 0x83, 0xb8}},
                                {"#ffd500", {0xff, 0xd5, 0x00}}}));
    EXPECT_EQ(inks_of("red:0.3mm,a=#000000:0.2cm"),
              (std::vector<Ink>{{"red", {0xe0, 0x10, 0x20}, 0.3}, {"a", {}, 2}}));
    EXPECT_EQ(inks_of("cmyk:0.4mm")[3].pen_mm, 0.4);
    EXPECT_EQ(paper_of("white"), kWhitePaper);
    EXPECT_NE(refusal_of([] { paper_of("a=#000000"); }), "accepted");
    for (const char* text :
         {"", ",", "red,", "red,red", "mauve", "#12345", "#1234567", "#12345g", "=#000000",
          "a b=#000000", "a,b", "red, blue", "a=b=#000000", "cmyk,red",
          "a=#000000,b=#000000,c=#000000,d=#000000,e=#000000,f=#000000,g=#000000,h=#000000,"
          "i=#000000,j=#000000,k=#000000,l=#000000,m=#000000,n=#000000,o=#000000,p=#000000,"
          "q=#000000"}) {
        EXPECT_TRUE(refusal_of([&] { inks_of(text); }).starts_with("inks ")) << text;
    }
}

}  // namespace separate_test
}  // namespace lacuna::pictures
