// What shows through a picture that is transparent.
#include <gtest/gtest.h>
#include <lacuna/errors.h>
#include <lacuna/pictures.h>
#include <png.h>

#include <string>
#include <vector>

#include "pictures/pictures.h"

namespace lacuna::pictures {
namespace {

// White art on transparency: a pixel that is transparent, and one that is half opaque.
const Picture kWhiteArt{png_bytes({2, 1, 8, PNG_COLOR_TYPE_GRAY_ALPHA}, {255, 0, 255, 128}),
                        "art.png"};

TEST(Background, IsWhiteUnlessItIsSaidToBeBlack) {
    Tone tone{.invert = true};
    EXPECT_EQ(importance_of(kWhiteArt, tone).importance, (std::vector<double>{1, 1}));
    tone.on_black = true;
    EXPECT_EQ(importance_of(kWhiteArt, tone).importance, (std::vector<double>{0, 128.0 / 255}));
    const Field ink = separate(kWhiteArt, inks_of("black"), {.on_black = true}).front();
    EXPECT_EQ(ink.importance[0], 1);
    EXPECT_NEAR(ink.importance[1], 1 - 128.0 / 255, 1e-4);
}

TEST(Background, ThatHidesTheWholePictureIsNamedInTheRefusal) {
    try {
        importance_of(kWhiteArt);
        FAIL() << "white on white was read";
    } catch (const FileError& error) {
        EXPECT_NE(std::string(error.what()).find("or, if it is transparent, --background black"),
                  std::string::npos)
            << error.what();
    }
}

}  // namespace
}  // namespace lacuna::pictures
