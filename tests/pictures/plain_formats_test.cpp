// Given PGM, PPM, PFM, Radiance HDR or npy as other programs write them, the pixels are read.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "pictures/image.h"
#include "pictures/pictures.h"

namespace lacuna::pictures {
namespace plain_formats_test {

using Values = std::vector<double>;

Values luminance_of(const std::string& bytes) {
    return decode_image(bytes, "file").luminance;
}

double bt709(double red, double green, double blue) {
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}

void expect_near(const Values& values, const Values& expected) {
    ASSERT_EQ(values.size(), expected.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        EXPECT_NEAR(values[i], expected[i], 1e-15 * std::max(1.0, expected[i])) << i;
}

TEST(APgm, OfTextMayHaveCommentsAnyBlanksAndAnyMaxval) {
    const Values expected{0, 0.1, 0.2, 0.5, 0.9, 1};
    for (const char* text : {"P2\n3 2\n10\n0 1 2\n5 9 10\n", "P2 3 2 10 0 1 2 5 9 10",
                             "P2\r\n# by hand\r\n3\r\n2 # rows\r\n10\t0 1 2 5 9 10 more",
                             "P2 3 2 010 0\v1\f2 # half way\n 05 9 10\n\n"}) {
        const Image image = decode_image(text, "file");
        EXPECT_EQ(image.columns, 3U);
        EXPECT_EQ(image.rows, 2U);
        EXPECT_EQ(image.luminance, expected) << text;
    }
    EXPECT_EQ(luminance_of("P2 1 1 65535 65534"), Values{65534.0 / 65535});
}

TEST(APgm, OfBytesHasTwoASampleFromMaxval256On) {
    EXPECT_EQ(luminance_of("P5\n2 2\n255\n" + bytes_of({0, 10, 32, 255})),
              (Values{0, 10.0 / 255, 32.0 / 255, 1}));
    EXPECT_EQ(luminance_of("P5 2 1 100\n" + bytes_of({10, 100, 7})), (Values{0.1, 1}));
    EXPECT_EQ(luminance_of("P5 2 1 256 " + bytes_of({1, 0, 0, 128})), (Values{1, 0.5}));
    EXPECT_EQ(luminance_of("P5 2 1 65535\n" + bytes_of({0xff, 0xff, 0x12, 0x34})),
              (Values{1, 0x1234 / 65535.0}));
}

TEST(APpm, OfTextAndBytesIsWeighedByBt709) {
    const Values expected{0.2126, 0.7152, 0.0722, 0.2};
    EXPECT_EQ(luminance_of("P3 2 2 5 5 0 0 0 5 0 0 0 5 1 1 1"), expected);
    EXPECT_EQ(luminance_of("P6 2 2 5 " + bytes_of({5, 0, 0, 0, 5, 0, 0, 0, 5, 1, 1, 1})), expected);
    EXPECT_EQ(luminance_of("P6 1 1 1000 " + bytes_of({3, 0xe8, 0, 0, 3, 0xe8})),
              Values{0.2126 + 0.0722});
}

TEST(APfm, HasItsRowsFromTheBottomUpInEitherByteOrder) {
    const std::vector<float> stored{0.5F, 0.75F, 1, 0, 0.125F, 0.25F};
    for (const bool big_endian : {false, true}) {
        const std::string scale = big_endian ? "2.5" : "-1e-3";
        const Image grey =
            decode_image("Pf\n3 2\n" + scale + "\n" + packed(stored, big_endian), "f");
        EXPECT_EQ(grey.columns, 3U);
        EXPECT_EQ(grey.rows, 2U);
        EXPECT_EQ(grey.luminance, (Values{0, 0.125, 0.25, 0.5, 0.75, 1}));
        EXPECT_EQ(grey.white, 1);
        expect_near(luminance_of("PF 1 2 " + scale + " " + packed(stored, big_endian)),
                    {bt709(0, 0.125, 0.25), bt709(0.5, 0.75, 1)});
    }
}

TEST(AFloatPicture, IsWhiteAtItsLargestLuminanceIfThatIsOver1) {
    const auto white_of = [](const std::vector<float>& values) {
        return decode_image("Pf 2 1 -1 " + packed(values, false), "file").white;
    };
    EXPECT_EQ(white_of({0, 0.5F}), 1);
    EXPECT_EQ(white_of({1, 0.5F}), 1);
    EXPECT_EQ(white_of({0.5F, 8}), 8);
    EXPECT_EQ(white_of({0, 3e38F}), double{3e38F});
}

TEST(AnHdrPicture, HasACommonExponentAPixel) {
    const std::string header = "#?RADIANCE\n# by hand\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=2\n\n";
    // 128 / 256 * 2^(e - 128)
    const Image image = decode_image(
        header + "-Y 2 +X 2\n" +
            bytes_of({128, 128, 128, 128, 128, 64, 0, 129, 0, 0, 0, 0, 255, 255, 255, 127}),
        "file");
    expect_near(image.luminance, {0.5, bt709(1, 0.5, 0), 0, 255.0 / 512});
    EXPECT_EQ(image.white, 1);
    const Image bright =
        decode_image("#?RGBE\n\n-Y 1 +X 1\n" + bytes_of({128, 128, 128, 138}), "file");
    EXPECT_EQ(bright.luminance, Values{512});
    EXPECT_EQ(bright.white, 512);
    EXPECT_EQ(luminance_of("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n" +
                           bytes_of({0, 128, 7, 128})),
              Values{0.5});
}

TEST(AnHdrPicture, MayHaveRunsOfPixelsOrOfChannels) {
    const Values nine(9, 0.5);
    const std::string old = "#?RGBE\n\n-Y 1 +X 9\n";
    EXPECT_EQ(luminance_of(old + bytes_of({128, 128, 128, 128, 1, 1, 1, 8})), nine);
    // A row of 300: 1 + 43 + 1 * 256
    EXPECT_EQ(luminance_of("#?RGBE\n\n-Y 1 +X 300\n" +
                           bytes_of({128, 128, 128, 128, 1, 1, 1, 43, 1, 1, 1, 1})),
              Values(300, 0.5));
    // Red in one run; green in a run, a literal and a run; blue in a literal; then exponents.
    const std::string header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 9\n";
    const std::string first = bytes_of({2, 2, 0,  9,  137, 128, 132, 128, 2,  64, 32,  131, 128,
                                        9, 1, 10, 20, 30,  40,  50,  60,  70, 80, 137, 128});
    const std::string second = bytes_of({2, 2, 0, 9, 137, 128, 137, 128, 137, 128, 137, 128});
    Values expected;
    for (int x = 0; x < 9; ++x) {
        const int green = x == 4 ? 64 : x == 5 ? 32 : 128;
        const int blue = x == 0 ? 1 : 10 * x;
        expected.push_back(bt709(0.5, green / 256.0, blue / 256.0));
    }
    expected.insert(expected.end(), nine.begin(), nine.end());
    expect_near(luminance_of(header + first + second), expected);
}

TEST(AnNpyArray, MayBeOfAnyTypeOrderAndNumberOfChannels) {
    const Samples samples{0, 1, 2, 253, 254, 255};
    for (const bool big_endian : {false, true}) {
        const std::string order = big_endian ? ">" : "<";
        Values wide;
        for (const double sample : samples) wide.push_back(sample / 65535);
        EXPECT_EQ(luminance_of(npy_bytes(order + "u2", "(2, 3)", packed(samples, big_endian))),
                  wide);
        const std::vector<float> floats{0, 0.25F, 0.5F, 1, 2, 4};
        EXPECT_EQ(luminance_of(npy_bytes(order + "f4", "(2, 3)", packed(floats, big_endian))),
                  (Values{0, 0.25, 0.5, 1, 2, 4}));
        const Values doubles{0, 0.1, 0.2, 0.3, 0.4, 0.5};
        const Image image =
            decode_image(npy_bytes(order + "f8", "(3, 2, 1)", packed(doubles, big_endian)), "file");
        EXPECT_EQ(image.columns, 2U);
        EXPECT_EQ(image.rows, 3U);
        EXPECT_EQ(image.luminance, doubles);
    }
    EXPECT_EQ(luminance_of(npy_bytes("|u1", "(2, 3)", bytes_of({0, 51, 102, 153, 204, 255}))),
              (Values{0, 0.2, 0.4, 0.6, 0.8, 1}));
}

TEST(AnNpyArray, MayBeOfTruthsWholeNumbersAndHalves) {
    EXPECT_EQ(luminance_of(npy_bytes("|b1", "(1, 2)", bytes_of({0, 1}))), (Values{0, 1}));
    const std::string two_wholes = bytes_of({3, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0});
    for (const std::string type : {"<i8", "<u8"}) {
        const Image image = decode_image(npy_bytes(type, "(2, 1)", two_wholes), "file");
        EXPECT_EQ(image.luminance, (Values{3, 256}));
        EXPECT_EQ(image.white, 256);
    }
    EXPECT_EQ(luminance_of(npy_bytes(">i4", "(1, 1)", bytes_of({0, 0, 1, 2}))), Values{258});
    EXPECT_EQ(luminance_of(npy_bytes("<u4", "(1, 1)", bytes_of({2, 1, 0, 0}))), Values{258});
    EXPECT_EQ(luminance_of(npy_bytes("<i2", "(1, 1)", bytes_of({2, 1}))), Values{258});
    EXPECT_EQ(luminance_of(npy_bytes("|i1", "(1, 1)", bytes_of({127}))), Values{127});
    // 1, 0.5, 65504, the least normal and the least of all halves.
    const std::string halves = bytes_of({0, 0x3c, 0, 0x38, 0xff, 0x7b, 0, 4, 1, 0});
    EXPECT_EQ(luminance_of(npy_bytes("<f2", "(1, 5)", halves)),
              (Values{1, 0.5, 65504, 0x1p-14, 0x1p-24}));
}

TEST(AnNpyArray, InFortranOrderIsTheSamePicture) {
    EXPECT_EQ(luminance_of(npy_bytes("|u1", "(2, 3)", bytes_of({0, 153, 51, 204, 102, 255}), true)),
              (Values{0, 0.2, 0.4, 0.6, 0.8, 1}));
    // (0, 0) red, (0, 1) green, (1, 0) blue, (1, 1) grey; columns first, then channels
    EXPECT_EQ(
        luminance_of(npy_bytes("|u1", "(2, 2, 3)",
                               bytes_of({255, 0, 0, 51, 0, 0, 255, 51, 0, 255, 0, 51}), true)),
        (Values{0.2126, 0.7152, 0.0722, 0.2}));
}

TEST(AnNpyArray, OfFourChannelsIsCompositedOverWhite) {
    EXPECT_EQ(luminance_of(npy_bytes("|u1", "(1, 2, 4)", bytes_of({0, 0, 0, 51, 0, 255, 0, 255}))),
              (Values{0.8, 0.7152}));
    // The brightest colour, 4, is white, and so is the background of transparent pixels.
    const Image image = decode_image(
        npy_bytes("<f8", "(1, 3, 4)", packed(Values{4, 4, 4, 1, 0, 0, 0, 0, 2, 2, 2, 0.5}, false)),
        "file");
    EXPECT_EQ(image.white, 4);
    EXPECT_EQ(image.luminance, (Values{4, 4, 3}));
}

}  // namespace plain_formats_test
}  // namespace lacuna::pictures
