// HEIC and AVIF, as libheif decodes them where it is installed.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "pictures/image.h"
#include "required.h"

namespace lacuna::pictures {
namespace {

// 16 x 16 pixels: the left half is white, the right one grey above and black below. Made with
// heif-enc of libheif 1.15.1.
constexpr std::string_view kHeic =
    "AAAAHGZ0eXBoZWljAAAAAG1pZjFoZWljbWlhZgAAAa1tZXRhAAAAAAAAACFoZGxyAAAAAAAAAABwaWN0AAAAAAAAAAAA"
    "AAAAAAAAAA5waXRtAAAAAAACAAAAEGlkYXQAAAAAABAAEAAAADhpbG9jAQAAAERAAAIAAQAAAAAAAAHRAAEAAAAAAAAA"
    "NAACAAEAAAAAAAAAAQAAAAAAAAAIAAAAOGlpbmYAAAAAAAIAAAAVaW5mZQIAAAEAAQAAaHZjMQAAAAAVaW5mZQIAAAAA"
    "AgAAZ3JpZAAAAADYaXBycAAAALZpcGNvAAAAdmh2Y0MBA3AAAAAAAAAAAAAe8AD8/fj4AAAPAyAAAQAYQAEMAf//A3AA"
    "AAMAkAAAAwAAAwAeugJAIQABACpCAQEDcAAAAwCQAAADAAADAB6gIIEFluqumubgQEDAgAAAAwCAAAADAIQiAAEABkQB"
    "wXPBiQAAABRpc3BlAAAAAAAAAEAAAABAAAAAFGlzcGUAAAAAAAAAEAAAABAAAAAQcGl4aQAAAAADCAgIAAAAGmlwbWEA"
    "AAAAAAAAAgABAoECAAICA4QAAAAaaXJlZgAAAAAAAAAOZGltZwACAAEAAQAAADxtZGF0AAAAMCgBrxMhZILA5fpmH+nk"
    "p/8WUB1T9T4CCrX9oAMG3owVbOgNQOKKoeWp8qdgUGux4A==";
constexpr std::string_view kAvif =
    "AAAAHGZ0eXBhdmlmAAAAAGF2aWZtaWYxbWlhZgAAAOptZXRhAAAAAAAAACFoZGxyAAAAAAAAAABwaWN0AAAAAAAAAAAA"
    "AAAAAAAAAA5waXRtAAAAAAABAAAAImlsb2MAAAAAREAAAQABAAAAAAEOAAEAAAAAAAAAGwAAACNpaW5mAAAAAAABAAAA"
    "FWluZmUCAAAAAAEAAGF2MDEAAAAAamlwcnAAAABLaXBjbwAAABNjb2xybmNseAACAAIABoAAAAAMYXYxQ4EADAAAAAAU"
    "aXNwZQAAAAAAAAAQAAAAEAAAABBwaXhpAAAAAAMICAgAAAAXaXBtYQAAAAAAAAABAAEEgYIDhAAAACNtZGF0EgAKCRgM"
    "/9ggQEDQgDIMRAAAJfE/sUFwUIlA";
// The same with a transparent upper left quarter, which is black.
constexpr std::string_view kTransparentAvif =
    "AAAAHGZ0eXBhdmlmAAAAAGF2aWZtaWYxbWlhZgAAAZhtZXRhAAAAAAAAACFoZGxyAAAAAAAAAABwaWN0AAAAAAAAAAAA"
    "AAAAAAAAAA5waXRtAAAAAAABAAAANGlsb2MAAAAAREAAAgACAAAAAAG8AAEAAAAAAAAAFQABAAAAAAHRAAEAAAAAAAAA"
    "GwAAADhpaW5mAAAAAAACAAAAFWluZmUCAAAAAAEAAGF2MDEAAAAAFWluZmUCAAAAAAIAAGF2MDEAAAAA12lwcnAAAACx"
    "aXBjbwAAABNjb2xybmNseAACAAIABoAAAAAMYXYxQ4EAHAAAAAAUaXNwZQAAAAAAAAAQAAAAEAAAAA5waXhpAAAAAAEI"
    "AAAAOGF1eEMAAAAAdXJuOm1wZWc6bXBlZ0I6Y2ljcDpzeXN0ZW1zOmF1eGlsaWFyeTphbHBoYQAAAAAMYXYxQ4EADAAA"
    "AAAUaXNwZQAAAAAAAAAQAAAAEAAAABBwaXhpAAAAAAMICAgAAAAeaXBtYQAAAAAAAAACAAEEgYYHiAACBIIDhIUAAAAa"
    "aXJlZgAAAAAAAAAOYXV4bAACAAEAAQAAADhtZGF0EgAKBRgM/9hUMgpEAAA2i99WjL6wEgAKCRgM/9ggQEDQgDIMRAAA"
    "JfE/sS29GRFo";

std::string decoded(std::string_view base64) {
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    std::uint32_t bits = 0;
    int count = 0;
    for (const char digit : base64.substr(0, base64.find('='))) {
        bits = bits << 6U | static_cast<std::uint32_t>(kDigits.find(digit));
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes += static_cast<char>(bits >> static_cast<unsigned>(count) & 255U);
    }
    return bytes;
}

// Why the test cannot run; empty if it can. LACUNA_REQUIRE may demand that it does.
std::string why_no_heif(std::string_view file) {
    if (tests::is_required("heif")) return {};
    try {
        decode_image(decoded(file), "picture");
    } catch (const FileError& error) {
        return error.what();
    }
    return {};
}

// The luminance in the middle of each quarter: above from left to right, then below.
using Quarters = std::array<double, 4>;
void expect_quarters(std::string_view file, const Quarters& expected,
                     Backdrop backdrop = Backdrop::white) {
    const Image image =
        decode_image(decoded(file), "picture", kMaxPixels, kMaxSide, {.backdrop = backdrop});
    ASSERT_EQ(image.columns, 16U);
    ASSERT_EQ(image.rows, 16U);
    constexpr std::array<std::size_t, 4> kMiddles{4 * 16 + 4, 4 * 16 + 12, 12 * 16 + 4,
                                                  12 * 16 + 12};
    for (std::size_t k = 0; k < 4; ++k)
        EXPECT_NEAR(image.luminance[kMiddles[k]], expected[k], 0.02) << k;
}

constexpr double kGrey = 128.0 / 255;

TEST(AHeif, OfAPhoneIsRead) {
    if (const std::string why = why_no_heif(kHeic); !why.empty()) GTEST_SKIP() << why;
    expect_quarters(kHeic, {1, kGrey, 1, 0});
}

TEST(AHeif, MayBeAnAvifAndTransparent) {
    if (const std::string why = why_no_heif(kAvif); !why.empty()) GTEST_SKIP() << why;
    expect_quarters(kAvif, {1, kGrey, 1, 0});
    expect_quarters(kTransparentAvif, {1, kGrey, 1, 0});
    expect_quarters(kTransparentAvif, {0, kGrey, 1, 0}, Backdrop::black);
}

TEST(AHeif, ThatCannotBeReadIsRefusedWithWhatToDo) {
    const auto refusal = [](std::string_view bytes) -> std::string {
        try {
            decode_image(bytes, "f");
        } catch (const FileError& error) {
            return error.what();
        }
        return "accepted";
    };
    const std::string heic = decoded(kHeic);
    for (const std::size_t size : {std::size_t{12}, heic.size() / 2, heic.size() - 40}) {
        const std::string why = refusal(std::string_view(heic).substr(0, size));
        const bool is_missing = why.find("convert it first") != std::string::npos;
        EXPECT_TRUE(is_missing || why.starts_with("f: not a HEIF that libheif can decode: "))
            << size << ": " << why;
        EXPECT_EQ(why.find('\n'), std::string::npos);
    }
    // The size in the header is not that of the pixels: 16 x 16 become 16 x 80 and 8 x 16.
    if (!why_no_heif(kHeic).empty()) return;
    for (const auto& [byte, value] : {std::pair{7, 80}, std::pair{3, 8}}) {
        std::string other = heic;
        for (std::size_t at = 0; (at = other.find("ispe", at)) != std::string::npos; at += 8)
            other[at + 8 + static_cast<std::size_t>(byte)] = static_cast<char>(value);
        const std::string why = refusal(other);
        EXPECT_TRUE(why.starts_with("f: not a whole HEIF: has 16 x 16 pixels, but says ") ||
                    why.starts_with("f: not a HEIF that libheif can decode: "))
            << why;
    }
}

TEST(AHeif, ThatIsAFilmIsRefused) {
    std::string film = decoded(kAvif);
    film.replace(4, 8, "ftypavis");
    try {
        decode_image(film, "f");
        FAIL();
    } catch (const FileError& error) {
        EXPECT_TRUE(std::string_view(error.what()).starts_with("f: an animated AVIF picture: "));
    }
}

}  // namespace
}  // namespace lacuna::pictures
