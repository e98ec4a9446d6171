// Given a picture, importance is high where it is dark, or with invert where it is bright.
#include "pictures/importance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "files/point_files.h"
#include "pictures/image.h"
#include "refusal.h"

namespace lacuna::pictures {
namespace {

using tests::refusal_of;
using Values = std::vector<double>;

Image image_of(const Values& luminance, double white = 1) {
    return {static_cast<std::uint32_t>(luminance.size()), 1, luminance, white, "cat.png"};
}

Values importance(const Values& luminance, const Importance& options = {}) {
    return importance_of(image_of(luminance), options).importance;
}

TEST(Importance, IsFullAtBlackAndNoneAtWhite) {
    const Field field = importance_of({2, 2, {0, 1, 0.25, 0.5}, 1, "file"}, {});
    EXPECT_EQ(field.columns, 2U);
    EXPECT_EQ(field.rows, 2U);
    EXPECT_EQ(field.importance, (Values{1, 0, 0.75, 0.5}));
}

// IEC 61966-2-1: 0.04045 / 12.92 at the end of the straight part, and 128 of 255 is 0.21586 light.
TEST(Importance, FollowsTheLightOfNumbersThatAreEncodedAsSrgb) {
    const Values grey{0, 10.0 / 255, 128.0 / 255, 1};
    EXPECT_EQ(importance_of(image_of(grey), {.light = true}).importance.front(), 1);
    EXPECT_NEAR(importance_of(image_of(grey), {.light = true}).importance[1], 1 - 0.0030353, 1e-6);
    EXPECT_NEAR(importance_of(image_of(grey), {.light = true}).importance[2], 1 - 0.2158605, 1e-6);
    EXPECT_EQ(importance_of(image_of(grey), {.light = true}).importance[3], 0);
    EXPECT_NEAR(importance_of(image_of(grey), {.invert = true, .light = true}).importance[2],
                0.2158605, 1e-6);
    Image of_light = image_of(grey);
    of_light.is_linear = true;
    EXPECT_EQ(importance_of(of_light, {.light = true}).importance,
              importance_of(image_of(grey), {}).importance);
    const std::string pfm("Pf\n1 1\n-1.0\n\0\0\0\x3f", 17);  // 0.5
    EXPECT_TRUE(decode_image(pfm, "half.pfm").is_linear);
    EXPECT_FALSE(decode_image("P2 1 1 1 0", "black.pgm").is_linear);
}

TEST(Importance, IsFullAtWhiteAndNoneAtBlackWithInvert) {
    EXPECT_EQ(importance({0, 1, 0.25, 0.5}, {.invert = true}), (Values{0, 1, 0.25, 0.5}));
}

TEST(Importance, IsStretchedBetweenBlackAndWhite) {
    EXPECT_EQ(importance({0, 0.25, 0.5, 0.75, 1}, {.black = 0.25, .white = 0.75}),
              (Values{1, 1, 0.5, 0, 0}));
    EXPECT_EQ(importance({0, 0.25, 0.5, 1}, {.white = 0.5, .invert = true}),
              (Values{0, 0.5, 1, 1}));
}

TEST(Importance, IsSharpenedAtEdgesAndNotElsewhere) {
    // White, then grey, then black: 40 pixels each.
    Values tones;
    for (const double tone : {1.0, 0.5, 0.0}) tones.insert(tones.end(), 40, tone);
    const Values plain = importance(tones);
    const Values sharp = importance(tones, {.sharpen = 2});
    const Values sharper = importance(tones, {.sharpen = 2, .sharpen_amount = 3});
    for (std::size_t i = 0; i < tones.size(); ++i) {
        const bool is_near = std::min(std::abs(static_cast<double>(i) - 39.5),
                                      std::abs(static_cast<double>(i) - 79.5)) < 6;
        const bool is_mid = i >= 40 && i < 80;
        EXPECT_TRUE((is_near && is_mid) || sharp[i] == plain[i]) << i;
    }
    EXPECT_GT(sharp[40], 0.6);  // the grey pixel beside white
    EXPECT_LT(sharp[79], 0.4);
    EXPECT_GT(sharper[40], sharp[40]);
    EXPECT_NEAR(sharper[42] - 0.5, 3 * (sharp[42] - 0.5), 1e-9);
    // At the first pixel after the step 53 of 125 ways of three means lead back to the white.
    EXPECT_NEAR(sharp[40], 0.5 + 0.5 * 53 / 125, 1e-9);
}

TEST(Importance, ThatIsSharpenedHasNoSolidRims) {
    Values tones(40, 1.0);
    tones.insert(tones.end(), 40, 0.25);
    const Values sharp = importance(tones, {.sharpen = 4, .sharpen_amount = 10});
    for (std::size_t i = 0; i < tones.size(); ++i)
        EXPECT_LE(sharp[i], 1 - tones[i] / 2) << i;  // half of the light is left
    EXPECT_NEAR(sharp[40], 0.875, 1e-9);
    for (double& tone : tones) tone = 1 - tone;
    const Values inverted = importance(tones, {.invert = true, .sharpen = 4, .sharpen_amount = 10});
    for (std::size_t i = 0; i < tones.size(); ++i) EXPECT_NEAR(inverted[i], sharp[i], 1e-9) << i;
}

TEST(Importance, OfAnUnderexposedPictureIsStretchedByAutoLevels) {
    // 1,000 tones from 0 to 0.25 and four dots of white, fewer than half a percent.
    Values dark;
    for (int i = 0; i < 1000; ++i) dark.push_back(i / 3996.0);
    for (const std::size_t i : {1U, 500U, 700U, 900U}) dark[i] = 1;
    const auto mean_of = [](const Values& values) {
        double sum = 0;
        for (const double value : values) sum += value;
        return sum / static_cast<double>(values.size());
    };
    EXPECT_GT(mean_of(importance(dark)), 0.85);
    EXPECT_NEAR(mean_of(importance(dark, {.auto_levels = true})), 0.5, 0.01);
    // One tone cannot be stretched.
    EXPECT_EQ(importance({0.25, 0.25}, {.auto_levels = true}), (Values{0.75, 0.75}));
}

// Ink of 0.1 and 0.5, and paper from 0.86 to 0.94.
TEST(Importance, OfAScanIsNoneOnItsPaperWithAutoLevels) {
    Values scan;
    for (int i = 0; i < 1000; ++i)
        scan.push_back(i % 10 == 0 ? 0.1 : i % 10 == 1 ? 0.5 : 0.86 + 0.08 * (i % 7) / 6);
    const Values found = importance(scan, {.auto_levels = true});
    Values negative = scan;
    for (double& one : negative) one = 1 - one;
    const Values light = importance(negative, {.auto_levels = true, .invert = true});
    for (std::size_t i = 0; i < scan.size(); ++i) {
        EXPECT_EQ(found[i] == 0, scan[i] > 0.8) << scan[i];
        EXPECT_NEAR(light[i], found[i], 0.05);
    }
    EXPECT_EQ(found[0], 1);
    EXPECT_NEAR(found[1], 0.4, 0.05);
    // Of even tones none is paper, nor are light ones that are fewer than half.
    Values even, few;
    for (int i = 0; i < 1000; ++i) {
        even.push_back(i / 999.0);
        few.push_back(i < 300 ? 0.85 : i / 1110.0);
    }
    EXPECT_GT(importance(even, {.auto_levels = true})[900], 0.05);
    EXPECT_GT(importance(few, {.auto_levels = true})[0], 0.02);
}

TEST(Importance, IsOfThePictureTurnedAndThenCut) {
    const Image picture{3, 2, {0, 0.1, 0.2, 0.3, 0.4, 0.5}, 1, "cat.png"};
    const auto cut_to = [&](std::uint32_t turn, const Part& part) {
        const Field field = importance_of(picture, {.invert = true, .turn = turn, .crop = part});
        return std::pair(field.columns, field.importance);
    };
    EXPECT_EQ(cut_to(90, {}), std::pair(2U, Values{0.3, 0, 0.4, 0.1, 0.5, 0.2}));
    EXPECT_EQ(cut_to(180, {}), std::pair(3U, Values{0.5, 0.4, 0.3, 0.2, 0.1, 0}));
    EXPECT_EQ(cut_to(270, {}), std::pair(2U, Values{0.2, 0.5, 0.1, 0.4, 0, 0.3}));
    EXPECT_EQ(cut_to(0, {1, 0, 2, 1}), std::pair(2U, Values{0.1, 0.2}));
    EXPECT_EQ(cut_to(90, {0, 1, 2, 2}), std::pair(2U, Values{0.4, 0.1, 0.5, 0.2}));
    EXPECT_EQ(refusal_of([&] {
                  cut_to(90, {0, 0, 3, 1});
              }),
              "crop 0,0,3,1: must lie within the 2 x 3 pixels of cat.png");
}

TEST(Importance, IsOfThePicturesOwnWhite) {
    EXPECT_EQ(importance_of(image_of({0, 2, 8}, 8), {}).importance, (Values{1, 0.75, 0}));
    EXPECT_EQ(importance_of(image_of({0, 2, 8}, 8), {.invert = true}).importance,
              (Values{0, 0.25, 1}));
}

TEST(Importance, IsRaisedToGammaWhichLeavesNoneAndFullAsTheyAre) {
    EXPECT_EQ(importance({0, 1, 0.25, 0.5}, {.gamma = 2}), (Values{1, 0, 0.5625, 0.25}));
    EXPECT_EQ(importance({0, 1, 0.75}, {.gamma = 0.5}), (Values{1, 0, 0.5}));
}

TEST(Importance, IsNowhereLessThanTheLeastWhichCountsAfterGamma) {
    EXPECT_EQ(importance({0, 1, 0.5}, {.gamma = 2, .min_importance = 0.3}), (Values{1, 0.3, 0.3}));
    EXPECT_EQ(importance({1, 1}, {.min_importance = 0.5}), (Values{0.5, 0.5}));
    EXPECT_EQ(importance({0, 1}, {.min_importance = 1}), (Values{1, 1}));
}

TEST(Importance, IsNeverMinusZero) {
    for (const double value : importance({-0.0, 1}, {.invert = true}))
        EXPECT_FALSE(std::signbit(value));
}

TEST(APictureWithoutImportance, IsRefusedByName) {
    const auto told = [](const Values& luminance, const Importance& options) -> std::string {
        try {
            importance(luminance, options);
            return "was taken";
        } catch (const files::FileError& error) {
            return error.what();
        }
    };
    const std::string white = told({1, 1, 1}, {});
    EXPECT_TRUE(white.starts_with("cat.png: white all over")) << white;
    EXPECT_NE(white.find("--invert"), std::string::npos) << white;
    const std::string black = told({0, 0}, {.invert = true});
    EXPECT_TRUE(black.starts_with("cat.png: black all over")) << black;
    EXPECT_EQ(told({1, 1, 0.999}, {}), "was taken");
}

// Each option that can be out of range; messages are in tests/refusals.txt.
TEST(AnOptionOfImportance, ThatIsNotAllowedIsRefusedByName) {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    const std::vector<std::pair<std::string, Importance>> cases{
        {"sharpen", {.sharpen = 1, .sharpen_amount = 0}},
        {"sharpen", {.sharpen = 1, .sharpen_amount = kNaN}},
        {"gamma", {.gamma = kNaN}},
        {"min-importance", {.min_importance = kNaN}},
        {"black", {.black = -0.1}},
        {"white", {.white = 1.5}},
        {"auto-levels", {.white = 0.9, .auto_levels = true}}};
    for (const auto& [option, options] : cases)
        EXPECT_TRUE(refusal_of([&, one = options] { check(one); }).starts_with(option + " "));
    EXPECT_EQ(refusal_of([] { check({.black = 0.1, .white = 0.9, .gamma = 1e-9}); }), "accepted");
    EXPECT_THROW(importance({0.5}, {.gamma = 1e9}), BadRequest);
}

}  // namespace
}  // namespace lacuna::pictures
