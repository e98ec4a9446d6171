// Tone::along: ellipses lie along the edges of a picture.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "pictures/importance.h"

namespace lacuna::pictures {
namespace along_test {

constexpr std::size_t kColumns = 120, kRows = 80;
constexpr double kRatio = 5;

// The stretches of a picture whose darkness at (x, y), in pixels, y upwards, is darkness(x, y).
template <class Darkness>
std::vector<Stretch> stretches(const Darkness& darkness) {
    std::vector<double> values;
    for (std::size_t row = 0; row < kRows; ++row)
        for (std::size_t column = 0; column < kColumns; ++column)
            values.push_back(
                darkness(static_cast<double>(column), static_cast<double>(kRows - 1 - row)));
    return stretches_along(values, kColumns, kRows, kRatio);
}

double waves(double x, double y, double angle, double length) {
    const double across = y * std::cos(angle) - x * std::sin(angle);
    return 0.5 + 0.5 * std::sin(2 * std::numbers::pi / length * across);
}

TEST(Along, GivenStripesThenEllipsesLieAlongThem) {
    for (const double degrees : {0.0, 30.0, 45.0, 77.0, 90.0, 135.0, 170.0}) {
        const double angle = degrees * std::numbers::pi / 180;
        const auto found = stretches([&](double x, double y) { return waves(x, y, angle, 12); });
        for (std::size_t i = 0; i < found.size(); ++i) {
            const Stretch& stretch = found[i];
            ASSERT_LE(stretch.ratio, kRatio * (1 + 1e-12)) << degrees;
            // Beyond the picture there are other stripes.
            if (i % kColumns < 4 || i % kColumns >= kColumns - 4) continue;
            if (i / kColumns < 4 || i / kColumns >= kRows - 4) continue;
            ASSERT_GT(stretch.ratio, 0.95 * kRatio) << degrees;
            ASSERT_NEAR(std::sin(stretch.angle - angle), 0, 0.02) << degrees;
        }
    }
}

TEST(Along, GivenNoEdgesThenThereAreDisks) {
    for (const Stretch& stretch : stretches([](double, double) { return 0.25; }))
        ASSERT_EQ(stretch.ratio, 1);
    // A slope of a tenth of a grey level a pixel is noise.
    for (const Stretch& stretch : stretches([](double x, double) { return x / 2550; }))
        ASSERT_LT(stretch.ratio, 1.01);
}

TEST(Along, GivenEdgesOfAllDirectionsThenThereAreAlmostDisks) {
    const auto found = stretches([](double x, double y) {
        return (waves(x, y, 0, 4) + waves(x, y, std::numbers::pi / 2, 4)) / 2;
    });
    for (std::size_t row = 20; row < kRows - 20; ++row)
        for (std::size_t column = 20; column < kColumns - 20; ++column)
            ASSERT_LT(found[row * kColumns + column].ratio, 1.6) << row << ", " << column;
}

TEST(Along, GivenOnePixelThenThereIsADisk) {
    ASSERT_EQ(stretches_along(std::vector<double>{1}, 1, 1, kRatio).size(), 1U);
    EXPECT_EQ(stretches_along(std::vector<double>{1}, 1, 1, kRatio).front().ratio, 1);
}

TEST(Along, IsPartOfTheTone) {
    const Image image{2, 2, {0, 1, 0, 1}, 1, "cat.png"};
    EXPECT_TRUE(importance_of(image, {}).stretches.empty());
    const Field field = importance_of(image, {.gamma = 2, .along = 3});
    ASSERT_EQ(field.stretches.size(), 4U);
    EXPECT_NEAR(std::cos(field.stretches.front().angle), 0, 1e-9) << "stripes from top to bottom";
    for (const double ratio : {0.5, -1.0, 1001.0, std::nan("")})
        EXPECT_THROW(importance_of(image, {.along = ratio}), BadRequest) << ratio;
}

}  // namespace along_test
}  // namespace lacuna::pictures
