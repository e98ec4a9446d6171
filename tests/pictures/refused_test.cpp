// Given a file that is no whole picture, the reader says what is wrong and where, in one line.
#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "files/point_files.h"
#include "pictures/image.h"
#include "pictures/pictures.h"

namespace lacuna::pictures {
namespace {

struct Refused {
    std::string name;
    std::string bytes;
    std::array<std::string, 4> told;
};

std::ostream& operator<<(std::ostream& out, const Refused& refused) {
    return out << refused.name;
}

void expect_one_line(const std::string& what) {
    EXPECT_TRUE(what.starts_with("a.png: ")) << what;
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    EXPECT_LT(what.size(), 250U) << what;
}

class ARefusedPicture : public testing::TestWithParam<Refused> {};

TEST_P(ARefusedPicture, IsToldInOneLineThatNamesFileAndReason) {
    try {
        decode_image(GetParam().bytes, "a.png");
        FAIL() << "was read";
    } catch (const files::FileError& error) {
        const std::string what = error.what();
        expect_one_line(what);
        for (const std::string& told : GetParam().told)
            EXPECT_NE(what.find(told), std::string::npos) << told << " in: " << what;
    }
}

std::string name_of_case(const testing::TestParamInfo<Refused>& info) {
    return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Content, ARefusedPicture,
                         testing::ValuesIn(std::vector<Refused>{
                             {"Empty", "", "empty", "must be a picture in PNG, JPEG"},
                             {"Text", "Dear reader,\nthis is no picture.",
                              R"(begins with "Dear reader,\nthi": must be a picture in PNG)"},
                             {"OneByte", "P", "begins with \"P\""},
                             {"Gif", "GIF89a\1", "a GIF picture", "convert it", "PNG"},
                             {"WebP", "RIFF\1\2\3\4WEBPVP8 ", "not a whole WebP"},
                             {"Tiff", std::string("II*\0\1\2", 6), "not a whole TIFF"},
                             {"BigEndianTiff", std::string("MM\0*\1\2", 6), "not a whole TIFF"},
                             {"Heif", "\1\2\3\4ftypheic", "a HEIF"},
                             {"Bmp", "BM\1\2\3", "a BMP picture", "PNG"},
                             {"Zeros", std::string(100, '\0'), "\\x"},
                             {"Bitmap", "P4\n8 1\n\xff", "P4", "P2 or P5"},
                             {"Pam", "P7\nWIDTH 1\n", "P7"}}),
                         name_of_case);

std::string ihdr(std::uint32_t columns, std::uint32_t rows, int depth, int type) {
    const auto number = [](std::uint32_t value) {
        const auto high = static_cast<std::uint16_t>(value >> 16U);
        return packed(Samples{high, static_cast<std::uint16_t>(value & 0xffffU)}, true);
    };
    return "\x89PNG\r\n\x1a\n" +
           png_chunk("IHDR", number(columns) + number(rows) +
                                 bytes_of({static_cast<std::uint16_t>(depth),
                                           static_cast<std::uint16_t>(type), 0, 0, 0}));
}

std::string changed(std::string bytes, std::size_t at, char by) {
    bytes[at] = static_cast<char>(bytes[at] ^ by);
    return bytes;
}

const std::string kPng = png_bytes({4, 3, 8, PNG_COLOR_TYPE_GRAY}, Samples(12, 9));

INSTANTIATE_TEST_SUITE_P(
    OfPng, ARefusedPicture,
    testing::ValuesIn(std::vector<Refused>{
        {"OnlyMagic", kPng.substr(0, 8), "not a whole PNG", "ends too early"},
        {"NoEnd", kPng.substr(0, kPng.size() - 12), "ends too early"},
        {"DamagedPixels", changed(kPng, 45, 1), "not a whole PNG"},
        {"DamagedHeader", changed(kPng, 30, 1), "CRC"},
        {"NoColumns", ihdr(0, 5, 8, 0), "0 x 5 pixels: must be at least 1 x 1"},
        {"NoRows", ihdr(5, 0, 8, 0), "5 x 0 pixels: must be at least 1 x 1"},
        {"LongSide", ihdr(2000000, 1, 8, 0), "2000000 x 1 pixels", "over 1048576"},
        {"ManyPixels", ihdr(100000, 100000, 1, 0), "100000 x 100000", "268435456 in all"},
        {"LargestNumbers", ihdr(0xffffffff, 0xffffffff, 16, 6), "4294967295"},
        {"Bomb", ihdr(16384, 16384, 16, 6) + png_chunk("IDAT", "x\x9c") + png_chunk("IEND", ""),
         "59 bytes cannot hold 16384 x 16384"},
        {"NoPixels", ihdr(1, 1, 8, 0) + png_chunk("IEND", ""), "not a whole PNG"},
        {"NoPalette", ihdr(1, 1, 8, 3) + png_chunk("IDAT", "x") + png_chunk("IEND", ""),
         "not a whole PNG"},
        {"Animated",
         kPng.substr(0, 33) + png_chunk("acTL", std::string("\0\0\0\2\0\0\0\0", 8)) +
             kPng.substr(33),
         "an animated PNG: must be one picture"},
        {"UnknownType", ihdr(1, 1, 8, 5), "not a whole PNG"}}),
    name_of_case);

const std::string kJpeg = jpeg_bytes({16, 16, 3}, Samples(768, 9));

// The height of the frame in a JPEG by libjpeg's writer: FF C0, length, precision, height, width.
std::string with_frame(std::string jpeg, const std::string& height_and_width) {
    const std::size_t frame = jpeg.find("\xff\xc0");
    return jpeg.replace(frame + 5, 4, height_and_width);
}

INSTANTIATE_TEST_SUITE_P(
    OfJpeg, ARefusedPicture,
    testing::ValuesIn(std::vector<Refused>{
        {"OnlyMagic", kJpeg.substr(0, 3), "not a whole JPEG"},
        {"NoEnd", kJpeg.substr(0, kJpeg.size() - 2), "Premature end"},
        {"HalfThePixels", kJpeg.substr(0, kJpeg.size() - 20), "Premature end"},
        {"NoRows", with_frame(kJpeg, std::string("\0\0\0\x10", 4)), "not a whole JPEG"},
        {"ManyPixels", with_frame(kJpeg, "\xf0\xf0\xf0\xf0"), "61680 x 61680"},
        {"Bomb", with_frame(kJpeg, "\x3f\x01\x3f\x01"), "cannot hold 16129 x 16129"},
        {"Arithmetic", jpeg_bytes({8, 8, 1, false, true}, Samples(64, 9)), "arithmetic",
         "Huffman"}}),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    OfNetpbm, ARefusedPicture,
    testing::ValuesIn(std::vector<Refused>{
        {"OnlyMagic", "P5", "ends before the width"},
        {"NoMaxval", "P5 3 2", "ends before maxval"},
        {"OnlyAComment", "P2 # 3 2 1", "ends before the width"},
        {"NegativeWidth", "P2 -3 2 1 0", "the width is \"-3\""},
        {"HugeWidth", "P2 99999999999999999999 2 1 0", "99999999999999999999"},
        {"NoColumns", "P5 0 2 255 ", "0 x 2 pixels"},
        {"ManyPixels", "P5 1000000 1000000 255 ", "1000000 x 1000000"},
        {"NoMaxvalAtAll", "P5 1 1 0 x", "maxval is 0"},
        {"LargeMaxval", "P5 1 1 65536 xx", "maxval is \"65536\"", "65535"},
        {"CutBytes", "P5 2 2 255 abc", "3 bytes of pixels: 4"},
        {"Bomb", "P5 16384 16384 255 abc", "3 bytes of pixels: 268435456"},
        {"TextBomb", "P2 16384 16384 255 1 2 3", "cannot hold 268435456 samples"},
        {"CutText", "P2 2 2 255 100 200 300", "row 1, column 0", "\"300\"", "up to 255"},
        {"EndedText", "P3 1 2 255 100 200 250 4    ", "ends before row 1, column 0"},
        {"Word", "P2 2 1 255 1 x", "row 0, column 1", "\"x\""},
        {"OverMaxval", "P5 2 1 100 \x10\x65", "row 0, column 1", "is 101", "100"},
        {"PairOverMaxval", "P6 1 2 256 " + bytes_of({0, 1, 1, 0, 0, 1, 0, 1, 1, 1, 1, 0}),
         "row 1, column 0", "is 257", "256"}}),
    name_of_case);

std::string pfm(float first, float second) {
    return "Pf 1 2 -1 " + packed(std::vector<float>{first, second}, false);
}

INSTANTIATE_TEST_SUITE_P(
    OfPfm, ARefusedPicture,
    testing::ValuesIn(std::vector<Refused>{
        {"OnlyMagic", "Pf", "the width of the PFM is \"\""},
        {"NoScale", "Pf 1 1 ", "the scale factor"},
        {"ZeroScale", "Pf 1 1 0 aaaa", "scale factor of the PFM is 0"},
        {"ScaleOfNaN", "Pf 1 1 nan aaaa", "nan"},
        {"NoRows", "PF 3 0 -1 ", "3 x 0 pixels"},
        {"Cut", "PF 1 1 -1 aaaabbbbccc", "11 bytes of pixels: 12"},
        {"Bomb", "PF 16384 16384 -1 aaaa", "4 bytes of pixels: 3221225472"},
        {"NegativeAtTheTop", pfm(1, -0.5F), "row 0, column 0", "-0.5", "0 or more"},
        {"NaNAtTheBottom", pfm(std::nanf(""), 1), "row 1, column 0", "nan", "finite"},
        {"Infinite", pfm(1, std::numeric_limits<float>::infinity()), "row 0, column 0", "inf"},
        {"NegativeBlue", "PF 1 1 -1 " + packed(std::vector<float>{1, 1, -1}, false),
         "row 0, column 0", "-1"}}),
    name_of_case);

std::string hdr(const std::string& size, const Samples& pixels) {
    return "#?RADIANCE\n\n" + size + "\n" + bytes_of(pixels);
}

INSTANTIATE_TEST_SUITE_P(
    OfHdr, ARefusedPicture,
    testing::ValuesIn(std::vector<Refused>{
        {"OnlyMagic", "#?RADIANCE", "ends in its header"},
        {"NoSize", "#?RADIANCE\n\n", "the size is given as \"\"", "-Y 480 +X 640"},
        {"OtherFormat", "#?RGBE\nFORMAT=32-bit_rle_cmyk\n\n-Y 1 +X 1\n....", "32-bit_rle_cmyk",
         "must be 32-bit_rle_rgbe"},
        {"BottomUp", hdr("+Y 1 +X 1", {1, 2, 3, 4}), "\"+Y 1 +X 1\""},
        {"MoreThanASize", hdr("-Y 1 +X 1 2", {1, 2, 3, 4}), "+X 1 2"},
        {"NoRows", hdr("-Y 0 +X 1", {}), "1 x 0 pixels"},
        {"Bomb", hdr("-Y 16384 +X 16384", {2, 2, 0x40, 0}), "cannot hold 16384 x 16384"},
        {"CutPixel", hdr("-Y 1 +X 2", {1, 2, 3, 4, 5}), "row 0", "cut off"},
        {"RunOfNothing", hdr("-Y 1 +X 2", {1, 1, 1, 1}), "row 0", "run that does not fit"},
        {"LongRunOfPixels", hdr("-Y 1 +X 2", {9, 9, 9, 9, 1, 1, 1, 2}), "row 0",
         "run that does not fit"},
        {"EmptyRunOfPixels", hdr("-Y 1 +X 2", {9, 9, 9, 9, 1, 1, 1, 0}), "row 0",
         "run that does not fit"},
        {"OtherWidth", hdr("-Y 1 +X 9", {2, 2, 0, 8, 137, 1}), "another width"},
        {"LongRun", hdr("-Y 1 +X 9", {2, 2, 0, 9, 138, 1}), "run that does not fit"},
        {"EmptyRun", hdr("-Y 1 +X 9", {2, 2, 0, 9, 0, 1}), "run that does not fit"},
        {"CutRun", hdr("-Y 1 +X 9", {2, 2, 0, 9, 5, 1, 2, 3}), "cut off"}}),
    name_of_case);

const std::string kNaN = packed(std::vector<double>{0, 1, 2, std::nan(""), 4, 5}, false);
const std::string kNegative = packed(std::vector<double>{0, 1, 2, 3, 4, -1e-300}, false);

INSTANTIATE_TEST_SUITE_P(
    OfNpy, ARefusedPicture,
    testing::ValuesIn(std::vector<Refused>{
        {"OnlyMagic", "\x93NUMPY", "version"},
        {"Flat", npy_bytes("<f8", "(6,)", kNaN), "(6,)", "rows x columns"},
        {"TwoChannels", npy_bytes("|u1", "(1, 1, 2)", "ab"), "(1, 1, 2)", "1, 3 or 4"},
        {"FourDimensions", npy_bytes("|u1", "(1, 1, 1, 1)", "a"), "(1, 1, 1, 1)"},
        {"NoRows", npy_bytes("<f8", "(0, 3)", ""), "3 x 0 pixels"},
        {"NoColumns", npy_bytes("<f8", "(3, 0)", ""), "0 x 3 pixels"},
        {"HugeShape", npy_bytes("<f8", "(4294967296, 4294967296)", ""), "4294967296 x 4294967296",
         "1048576"},
        {"Bomb", npy_bytes("<f8", "(16384, 16384)", "abc"), "3 bytes of data: 2147483648"},
        {"Cut", npy_bytes("<u2", "(1, 2)", "abc"), "3 bytes of data: 4"},
        {"More", npy_bytes("|u1", "(1, 2)", "abc"), "3 bytes of data: 2"},
        {"Complex", npy_bytes("<c8", "(1, 1)", "12345678"), "\"<c8\"", "b1, i1 to i8"},
        {"NegativeWhole", npy_bytes("|i1", "(1, 1)", "\xff"), "is -1", "0 or more"},
        {"HalfNaN", npy_bytes("<f2", "(1, 1)", std::string("\0\x7e", 2)), "nan"},
        {"NaN", npy_bytes("<f8", "(2, 3)", kNaN), "row 1, column 0", "nan", "finite"},
        {"NaNInFortranOrder", npy_bytes("<f8", "(2, 3)", kNaN, true), "row 1, column 1", "nan"},
        {"Negative", npy_bytes("<f8", "(2, 3)", kNegative), "row 1, column 2", "-1e-300"},
        {"Alpha", npy_bytes("<f8", "(1, 1, 4)", packed(std::vector<double>{1, 1, 1, 1.5}, false)),
         "row 0, column 0", "1.5", "0 to 1", "alpha"}}),
    name_of_case);

TEST(APicture, OfMorePixelsThanAllowedIsRefusedAndOneOfExactlyThatManyIsRead) {
    for (const auto& [name, bytes] : one_of_each()) {
        const Image image = decode_image(bytes, name);
        const std::uint64_t pixels = image.luminance.size();
        EXPECT_EQ(pixels, std::uint64_t{image.columns} * image.rows) << name;
        EXPECT_EQ(decode_image(bytes, name, pixels).luminance, image.luminance);
        EXPECT_THROW(decode_image(bytes, name, pixels - 1), files::FileError) << name;
    }
}

TEST(APicture, ThatIsTooLongIsRefusedByItsHeaderAlone) {
    // 2.1 GB of luminance, were it decoded.
    const std::string bytes = "P5 1048576 256 255\n";
    try {
        decode_image(bytes, "a.pgm", kMaxPixels, 1000);
        ADD_FAILURE() << "was read";
    } catch (const files::FileError& error) {
        EXPECT_EQ(std::string(error.what()),
                  "a.pgm: 1048576 x 256 pixels: the longer side may be at most 1000 times the "
                  "shorter");
    }
    for (const auto& [name, whole] : one_of_each()) {
        const Image image = decode_image(whole, name);
        const std::uint64_t longer = std::max(image.columns, image.rows);
        const std::uint64_t shorter = std::min(image.columns, image.rows);
        EXPECT_EQ(decode_image(whole, name, kMaxPixels, (longer + shorter - 1) / shorter).luminance,
                  image.luminance);
        if (longer == shorter) continue;
        EXPECT_THROW(decode_image(whole, name, kMaxPixels, (longer - 1) / shorter),
                     files::FileError)
            << name;
    }
}

TEST(APicture, CutOffAnywhereIsRefused) {
    for (const auto& [name, bytes] : one_of_each()) {
        // A text may lose its last line's end, and digits if a number remains.
        const std::size_t spared = name.starts_with("text.") ? 4 : 0;
        for (std::size_t size = 0; size + spared < bytes.size(); ++size) {
            try {
                decode_image(std::string_view(bytes).substr(0, size), "a.png");
                ADD_FAILURE() << name << " was read, cut to " << size << " of " << bytes.size();
            } catch (const files::FileError& error) {
                expect_one_line(error.what());
            }
        }
    }
}

TEST(AHostilePicture, IsReadOrRefusedButNeverBreaksTheReader) {
    std::mt19937 random(1);
    for (const auto& [name, whole] : one_of_each())
        for (int i = 0; i < 1000; ++i) {
            std::string bytes = whole;
            for (unsigned k = 1 + random() % 4; k > 0; --k)
                bytes[random() % bytes.size()] = static_cast<char>(random() % 256);
            try {
                const Image image = decode_image(bytes, "a.png", 1U << 16U);
                for (const double luminance : image.luminance)
                    ASSERT_TRUE(luminance >= 0 && luminance <= image.white) << name;
            } catch (const files::FileError& error) {
                expect_one_line(error.what());
            }
        }
}

}  // namespace
}  // namespace lacuna::pictures
