// Angles that are the same on every machine.
#include "base/angle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace lacuna {
namespace {

constexpr double kRounding = 1e-15;

TEST(Direction, IsThatOfTheCLibraryButForTheLastDigits) {
    std::mt19937_64 random(1);
    for (const double most : {1e-9, 1.0, 7.0, 1000.0})
        for (int turn = 0; turn < 20'000; ++turn) {
            const double angle = std::uniform_real_distribution<double>(-most, most)(random);
            const Direction found = direction_of(angle);
            ASSERT_NEAR(found.x, std::cos(angle), kRounding) << angle;
            ASSERT_NEAR(found.y, std::sin(angle), kRounding) << angle;
        }
    EXPECT_EQ(direction_of(0).x, 1);
    EXPECT_EQ(direction_of(0).y, 0);
}

TEST(Angle, IsThatOfTheCLibraryButForTheLastDigits) {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> any(-1, 1);
    for (const double scale : {1.0, 1e-8, 1e-150})
        for (int turn = 0; turn < 20'000; ++turn) {
            const double x = any(random), y = scale * any(random);
            ASSERT_NEAR(angle_of(x, y), std::atan2(y, x), kRounding) << x << " " << y;
            ASSERT_NEAR(angle_of(y, x), std::atan2(x, y), kRounding) << y << " " << x;
        }
}

TEST(Angle, IsExactOnTheAxes) {
    EXPECT_EQ(angle_of(0, 0), 0);
    EXPECT_EQ(angle_of(2, 0), 0);
    EXPECT_EQ(angle_of(-2, 0), std::numbers::pi);
    EXPECT_EQ(angle_of(0, 3), std::numbers::pi / 2);
    EXPECT_EQ(angle_of(0, -3), -std::numbers::pi / 2);
}

}  // namespace
}  // namespace lacuna
