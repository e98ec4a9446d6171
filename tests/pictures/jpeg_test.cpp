// Given a JPEG of any supported kind, its pixels come back as closely as the format keeps them.
#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "pictures/image.h"
#include "pictures/pictures.h"

namespace lacuna::pictures {
namespace {

constexpr double kStep = 1.0 / 255;

TEST(AJpeg, OfGreyIsReadBaselineAndProgressive) {
    constexpr std::uint32_t kColumns = 37;
    constexpr std::uint32_t kRows = 21;
    Samples samples;
    for (std::uint32_t y = 0; y < kRows; ++y)
        for (std::uint32_t x = 0; x < kColumns; ++x)
            samples.push_back(static_cast<std::uint16_t>(3 * x + 7 * y));
    for (const bool progressive : {false, true}) {
        const Image image =
            decode_image(jpeg_bytes({kColumns, kRows, 1, progressive}, samples), "file");
        ASSERT_EQ(image.columns, kColumns);
        ASSERT_EQ(image.rows, kRows);
        EXPECT_EQ(image.white, 1);
        for (std::size_t i = 0; i < samples.size(); ++i)
            ASSERT_NEAR(image.luminance[i], samples[i] / 255.0, 1.01 * kStep) << i;
    }
}

TEST(AJpeg, OfColourIsWeighedByBt709NotByItsOwnLuma) {
    for (const bool progressive : {false, true})
        for (const Samples& colour : {Samples{255, 0, 0}, Samples{0, 255, 0}, Samples{0, 0, 255},
                                      Samples{200, 100, 50}, Samples{77, 77, 77}}) {
            Samples samples;
            for (int i = 0; i < 16 * 16; ++i)
                samples.insert(samples.end(), colour.begin(), colour.end());
            const Image image = decode_image(jpeg_bytes({16, 16, 3, progressive}, samples), "file");
            const double expected =
                (0.2126 * colour[0] + 0.7152 * colour[1] + 0.0722 * colour[2]) / 255;
            for (const double luminance : image.luminance)
                ASSERT_NEAR(luminance, expected, 2 * kStep);
        }
}

// libjpeg writes Adobe's marker, which inverts the numbers: 255 is no ink.
TEST(AJpeg, OfCmykIsReadWithoutAPrintersProfile) {
    for (const Samples& paper :
         {Samples{255, 255, 255, 255}, Samples{255, 255, 255, 0}, Samples{0, 0, 0, 255},
          Samples{255, 0, 0, 255}, Samples{200, 100, 50, 128}}) {
        Samples samples;
        for (int i = 0; i < 16 * 16; ++i) samples.insert(samples.end(), paper.begin(), paper.end());
        const Image image = decode_image(jpeg_bytes({16, 16, 4}, samples), "file");
        const double expected =
            (0.2126 * paper[0] + 0.7152 * paper[1] + 0.0722 * paper[2]) / 255 * paper[3] / 255;
        for (const double luminance : image.luminance) ASSERT_NEAR(luminance, expected, 2 * kStep);
    }
}

// A camera's picture; when turned upright its dark spot is at the top left, on 3 x 2 blocks of 8.
TEST(AJpeg, IsTurnedAsExifSays) {
    for (int orientation = 1; orientation <= 8; ++orientation)
        for (const bool big_endian : {false, true}) {
            // The corner where row 0 and column 0 of the stored picture are seen, by Exif's table.
            const bool is_turned = orientation >= 5;
            const bool at_right =
                orientation == 2 || orientation == 3 || orientation == 6 || orientation == 7;
            const bool at_bottom =
                orientation == 3 || orientation == 4 || orientation == 7 || orientation == 8;
            Samples samples(std::size_t{24} * 16, 255);
            // Dark along the stored row 0, darkest in its first block.
            for (std::size_t y = 0; y < 8; ++y)
                for (std::size_t x = 0; x < 24; ++x)
                    samples[y * 24 + x] = static_cast<std::uint16_t>(x < 8 ? 0 : 100);
            const Image image = decode_image(
                jpeg_bytes({24, 16, 1, false, false, exif(orientation, big_endian)}, samples),
                "file");
            ASSERT_EQ(image.columns, is_turned ? 16U : 24U);
            ASSERT_EQ(image.rows, is_turned ? 24U : 16U);
            const auto at = [&](bool right, bool bottom) {
                return image.luminance[(bottom ? image.rows - 1 : 0) * image.columns +
                                       (right ? image.columns - 1 : 0)];
            };
            EXPECT_NEAR(at(at_right, at_bottom), 0, kStep) << orientation;
            EXPECT_NEAR(at(!at_right, !at_bottom), 1, kStep) << orientation;
            const bool row_ends_right = at_right == is_turned;
            const bool row_ends_at_bottom = at_bottom != is_turned;
            EXPECT_NEAR(at(row_ends_right, row_ends_at_bottom), 100.0 / 255, kStep) << orientation;
            EXPECT_NEAR(at(!row_ends_right, !row_ends_at_bottom), 1, kStep) << orientation;
        }
}

TEST(AJpeg, WithExifThatCannotBeReadIsLeftAsItIs) {
    const Samples samples(std::size_t{8} * 16, 9);
    std::vector<std::string> markers = {exif(0, true), exif(9, false), "Exif", "http://ns"};
    constexpr std::size_t kEndOfValue = 38;
    for (std::size_t size = 0; size < kEndOfValue; ++size)
        markers.push_back(exif(6, true).substr(0, size));
    markers.push_back(exif(6, true).replace(10, 4, "\xff\xff\xff\xff"));
    markers.push_back(exif(6, true).replace(6, 2, "XX"));
    for (const std::string& marker : markers) {
        const Image image =
            decode_image(jpeg_bytes({8, 16, 1, false, false, marker}, samples), "file");
        EXPECT_EQ(image.columns, 8U) << testing::PrintToString(marker);
    }
}

}  // namespace
}  // namespace lacuna::pictures
