// Given a PNG of any kind that libpng writes, its pixels are read back.
#include <gtest/gtest.h>
#include <png.h>

#include <cstddef>
#include <string>
#include <vector>

#include "pictures/image.h"
#include "pictures/pictures.h"

namespace lacuna::pictures {
namespace {

std::vector<double> expected_of(const Samples& samples, double max) {
    std::vector<double> expected;
    for (const double sample : samples) expected.push_back(sample / max);
    return expected;
}

TEST(APng, OfGreyInAnyDepthAndSizeInterlacedOrNotGivesEachSampleOverTheLargest) {
    for (const int depth : {1, 2, 4, 8, 16}) {
        const unsigned max = (1U << static_cast<unsigned>(depth)) - 1;
        for (const bool interlaced : {false, true})
            for (const auto& [columns, rows] : std::vector<std::pair<std::uint32_t, std::uint32_t>>{
                     {1, 1}, {1, 9}, {9, 1}, {3, 2}, {17, 13}, {2000, 3}}) {
                const Samples samples = pattern(std::size_t{columns} * rows, max);
                const Image image = decode_image(
                    png_bytes({columns, rows, depth, PNG_COLOR_TYPE_GRAY, interlaced}, samples),
                    "file");
                EXPECT_EQ(image.columns, columns);
                EXPECT_EQ(image.rows, rows);
                EXPECT_EQ(image.white, 1);
                EXPECT_EQ(image.name, "file");
                EXPECT_EQ(image.luminance, expected_of(samples, max))
                    << depth << ' ' << interlaced << ' ' << columns << " x " << rows;
            }
    }
}

TEST(APng, OfColourIsWeighedByBt709AndGreyInColourIsThatGrey) {
    for (const int depth : {8, 16})
        for (const bool interlaced : {false, true}) {
            const auto max = static_cast<std::uint16_t>(depth == 8 ? 255 : 65535);
            const Samples samples{max, 0, 0, 0, max, 0, 0, 0, max, 77, 77, 77, 200, 100, 50};
            const Image image = decode_image(
                png_bytes({5, 1, depth, PNG_COLOR_TYPE_RGB, interlaced}, samples), "file");
            EXPECT_EQ(image.luminance, (std::vector<double>{0.2126, 0.7152, 0.0722, 77.0 / max,
                                                            (200 * 2126 + 100 * 7152 + 50 * 722) /
                                                                (10000.0 * max)}));
        }
}

TEST(APng, WithAlphaIsCompositedOverWhite) {
    const Image grey = decode_image(
        png_bytes({4, 1, 8, PNG_COLOR_TYPE_GRAY_ALPHA}, {0, 0, 0, 255, 90, 255, 0, 51}), "file");
    EXPECT_EQ(grey.luminance, (std::vector<double>{1, 0, 90.0 / 255, 0.8}));
    const Image colour =
        decode_image(png_bytes({3, 1, 16, PNG_COLOR_TYPE_RGBA},
                               {0, 0, 0, 0, 65535, 0, 0, 65535, 0, 65535, 0, 13107}),
                     "file");
    EXPECT_EQ(colour.luminance[0], 1);
    EXPECT_EQ(colour.luminance[1], 0.2126);
    EXPECT_DOUBLE_EQ(colour.luminance[2], 0.2 * 0.7152 + 0.8);
}

TEST(APng, OfAPaletteGivesItsColoursAndTheirTransparency) {
    for (const int depth : {1, 2, 4, 8}) {
        Png png{2, 2, depth, PNG_COLOR_TYPE_PALETTE};
        png.palette = {{255, 0, 0}, {51, 51, 51}};
        EXPECT_EQ(decode_image(png_bytes(png, {0, 1, 1, 0}), "file").luminance,
                  (std::vector<double>{0.2126, 0.2, 0.2, 0.2126}));
        png.palette_alpha = {0};
        EXPECT_EQ(decode_image(png_bytes(png, {0, 1, 1, 0}), "file").luminance,
                  (std::vector<double>{1, 0.2, 0.2, 1}));
    }
}

TEST(APng, WithATransparentColourIsWhiteThere) {
    for (const int depth : {2, 8, 16}) {
        Png grey{3, 1, depth, PNG_COLOR_TYPE_GRAY};
        grey.transparent = {1};
        const Image image = decode_image(png_bytes(grey, {0, 1, 2}), "file");
        EXPECT_EQ(image.luminance[0], 0);
        EXPECT_EQ(image.luminance[1], 1);
        EXPECT_EQ(image.luminance[2], 2.0 / ((1 << depth) - 1));
    }
    Png colour{2, 1, 8, PNG_COLOR_TYPE_RGB};
    colour.transparent = {9, 8, 7};
    EXPECT_EQ(decode_image(png_bytes(colour, {9, 8, 7, 9, 9, 9}), "file").luminance,
              (std::vector<double>{1, 9.0 / 255}));
}

TEST(APng, IsReadAsStoredWhateverGammaAndTextsStandAroundIt) {
    Png png{3, 1, 8, PNG_COLOR_TYPE_GRAY};
    png.with_profile_and_text = true;
    EXPECT_EQ(decode_image(png_bytes(png, {0, 51, 255}), "file").luminance,
              (std::vector<double>{0, 0.2, 1}));
}

}  // namespace
}  // namespace lacuna::pictures
