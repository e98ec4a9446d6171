// Given a picture, the public header makes importance of it.
#include <gtest/gtest.h>
#include <lacuna/pictures.h>

#include <string_view>
#include <vector>

namespace {

using namespace lacuna;

TEST(DecodeField, MakesDarkDenseAndHeedsTheTone) {
    const std::string_view pgm = "P2 3 1 4\n0 2 4\n";
    const Field field = importance_of({std::string(pgm), "grey"});
    EXPECT_EQ(field.columns, 3U);
    EXPECT_EQ(field.rows, 1U);
    EXPECT_EQ(field.importance, (std::vector<double>{1, 0.5, 0}));
    Tone tone;
    tone.invert = true;
    tone.white = 0.5;
    EXPECT_EQ(importance_of({std::string(pgm), "grey"}, tone).importance,
              (std::vector<double>{0, 1, 1}));
}

TEST(DecodeField, RefusesOtherBytesAndTones) {
    EXPECT_THROW(importance_of({"no picture", "text"}), FileError);
    Tone tone;
    tone.gamma = 0;
    EXPECT_THROW(importance_of({"P2 1 1 4\n0\n", "grey"}, tone), BadRequest);
    EXPECT_THROW(importance_of(read_picture("/nowhere/at/all.png")), FileError);
}

}  // namespace
