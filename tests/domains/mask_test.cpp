// Masks from pictures: pixels that are not 0 are allowed.
#include <gtest/gtest.h>
#include <lacuna/domains.h>
#include <png.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace lacuna;

// A PNG with 8 bits a channel.
std::string png_of(std::uint32_t columns, std::uint32_t rows, std::uint32_t format,
                   const std::vector<std::uint8_t>& samples) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = columns;
    image.height = rows;
    image.format = format;
    png_alloc_size_t size = 0;
    EXPECT_NE(png_image_write_to_memory(&image, nullptr, &size, 0, samples.data(), 0, nullptr), 0);
    std::string bytes(size, '\0');
    EXPECT_NE(png_image_write_to_memory(&image, bytes.data(), &size, 0, samples.data(), 0, nullptr),
              0);
    return bytes;
}

using Allowed = std::vector<std::uint8_t>;

TEST(AMaskFromAPicture, AllowsPixelsThatAreNotBlack) {
    const Mask mask = decode_mask(png_of(3, 2, PNG_FORMAT_GRAY, {0, 1, 255, 128, 0, 0}), "file");
    EXPECT_EQ(mask.columns, 3U);
    EXPECT_EQ(mask.rows, 2U);
    EXPECT_EQ(mask.allowed, (Allowed{0, 1, 1, 1, 0, 0}));
}

TEST(AMaskFromAPicture, AllowsAnyChannelThatIsNotZero) {
    EXPECT_EQ(
        decode_mask(png_of(4, 1, PNG_FORMAT_RGB, {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}), "file")
            .allowed,
        (Allowed{0, 1, 1, 1}));
}

TEST(AMaskFromAPicture, ForbidsWhatIsTransparent) {
    EXPECT_EQ(decode_mask(png_of(4, 1, PNG_FORMAT_RGBA,
                                 {255, 255, 255, 0, 1, 0, 0, 1, 0, 0, 0, 255, 0, 0, 9, 255}),
                          "file")
                  .allowed,
              (Allowed{0, 1, 0, 1}));
}

TEST(AMaskFromAPicture, MayBeAnArrayOfTruthsOrNumbers) {
    const auto npy = [](std::string_view type, std::string_view data) {
        std::string header =
            "{'descr': '" + std::string(type) + "', 'fortran_order': False, 'shape': (1, 3), }";
        header.resize(117, ' ');
        header += '\n';
        return std::string("\x93NUMPY\x01\x00\x76\x00", 10) + header + std::string(data);
    };
    EXPECT_EQ(decode_mask(npy("|b1", std::string_view("\0\1\0", 3)), "file").allowed,
              (Allowed{0, 1, 0}));
    EXPECT_EQ(
        decode_mask(npy("<i4", std::string_view("\0\0\0\0\0\1\0\0\7\0\0\0", 12)), "file").allowed,
        (Allowed{0, 1, 1}));
    // The middle value is the least positive float.
    EXPECT_EQ(
        decode_mask(npy("<f4", std::string_view("\0\0\0\0\1\0\0\0\0\0\0\0", 12)), "file").allowed,
        (Allowed{0, 1, 0}));
}

TEST(AMaskFromAPicture, MayBeBlackAllOver) {
    EXPECT_EQ(decode_mask(png_of(1, 2, PNG_FORMAT_GRAY, {0, 0}), "file").allowed, (Allowed{0, 0}));
}

}  // namespace
