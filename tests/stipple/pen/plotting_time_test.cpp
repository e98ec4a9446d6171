// A pen takes as long as it must accelerate and slow down.
#include "stipple/pen/plotting_time.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <vector>

#include "stipple/pen/pen_path.h"

namespace lacuna::pen {
namespace {

// 50 mm/s and 1000 mm/s^2 with the pen down, 100 mm/s and 1500 mm/s^2 with the pen up.
constexpr Plotter kPlotter{.seconds_per_dot = 0,
                           .seconds_per_metre_down = 20,
                           .seconds_per_metre_up = 10,
                           .seconds_per_corner = 0.05};

double down(const std::vector<Point>& line, const Plotter& plotter = kPlotter) {
    return seconds_down(plotter, line, 1);
}

TEST(PlottingTime, FromStopToStopIsThatOfAnEvenAcceleration) {
    EXPECT_DOUBLE_EQ(seconds_straight_down(kPlotter, 1000), 20 + 0.05);
    EXPECT_DOUBLE_EQ(seconds_straight_down(kPlotter, 0.4), 2 * std::sqrt(0.4 / 1000));
    EXPECT_DOUBLE_EQ(seconds_up(kPlotter, 1000), 10 + 100 / 1500.0);
    EXPECT_DOUBLE_EQ(seconds_up(kPlotter, 1.5), 2 * std::sqrt(1.5 / 1500));
    EXPECT_EQ(seconds_up(kPlotter, 0), 0);
    // At full speed all the way, or with no time for any.
    EXPECT_DOUBLE_EQ(seconds_up({0, 20, 10, 0}, 1.5), 0.015);
    EXPECT_DOUBLE_EQ(down({{0, 0}, {1, 0}, {1, 1}}, {0, 20, 10, 0}), 0.04);
    EXPECT_EQ(down({{0, 0}, {1, 0}, {1, 1}}, {0, 0, 10, 1}), 0);
}

TEST(PlottingTime, AroundADotIsAsSlowAsItsCirclesAsk) {
    // On a radius of 0.4 mm 1000 mm/s^2 sideways allow 20 mm/s; on one of 10 mm the pen is at 50.
    EXPECT_DOUBLE_EQ(seconds_around(kPlotter, drawing::pen_dot(1, 0.2, true)),
                     2 * std::numbers::pi * 0.4 / 20 + 20 / 1000.0);
    EXPECT_DOUBLE_EQ(seconds_around(kPlotter, drawing::pen_dot(21, 1, true)),
                     2 * std::numbers::pi * 10 / 50 + 50 / 1000.0);
    EXPECT_EQ(seconds_around(kPlotter, {}), 0);
    EXPECT_EQ(seconds_around({0, 0, 0, 0}, drawing::pen_dot(21, 1, false)), 0);
}

TEST(PlottingTime, OfALineIsLongerTheSharperItsCornersAre) {
    EXPECT_EQ(down({}), 0);
    EXPECT_EQ(down({{1, 1}}), 0);
    EXPECT_EQ(down({{1, 1}, {1, 1}}), 0);
    for (const double length : {0.2, 1.0, 30.0}) {
        const double straight = seconds_straight_down(kPlotter, 2 * length);
        const double stopped = 2 * seconds_straight_down(kPlotter, length);
        EXPECT_NEAR(down({{0, 0}, {length, 0}, {length, 0}, {2 * length, 0}}), straight, 1e-12);
        double before = straight;
        for (int degrees = 30; degrees <= 180; degrees += 30) {
            const double angle = degrees * std::numbers::pi / 180;
            const double x = length + length * std::cos(angle), y = length * std::sin(angle);
            const double seconds = down({{0, 0}, {length, 0}, {x, y}});
            EXPECT_GT(seconds, before - 1e-12) << length << " " << degrees;
            EXPECT_LE(seconds, stopped + 1e-12);
            before = seconds;
        }
        EXPECT_NEAR(before, stopped, 1e-9) << "back on the same line";
    }
    // On an arc that leaves a right angle by 0.05 mm the pen has 0.1207 mm of radius, and 10.99
    // mm/s.
    const double corner = std::sqrt(1000 * 0.05 * std::sqrt(0.5) / (1 - std::sqrt(0.5)));
    const double lost = (50 - corner) * (50 - corner) / (1000 * 50);
    EXPECT_NEAR(down({{0, 0}, {30, 0}, {30, 30}}), 60 / 50.0 + 0.05 + lost, 1e-9);
}

TEST(PlottingTime, BeforeManyCornersIsNoLessThanWhatEachOfThemAllows) {
    // A saw: between teeth of 1 mm the pen would get to full speed only after 1.25 mm.
    std::vector<Point> saw, straight;
    for (int i = 0; i <= 100; ++i) {
        saw.push_back({i / std::sqrt(2), (i % 2) / std::sqrt(2)});
        straight.push_back({double(i), 0});
    }
    const double corner = std::sqrt(1000 * 0.05 * std::sqrt(0.5) / (1 - std::sqrt(0.5)));
    const double most = std::sqrt(corner * corner + 1000);
    EXPECT_NEAR(down(saw) / 100, 2 * (most - corner) / 1000, 0.001);
    EXPECT_NEAR(down(straight), 100 / 50.0 + 0.05, 1e-9);
}

TEST(PlottingTime, OfPenPathsIsALittleLessThanWhatIsExpected) {
    std::mt19937_64 random(5);
    std::vector<Point> points, path;
    for (int i = 0; i < 3000; ++i)
        points.push_back(
            {std::ldexp(double(random() >> 11U), -53), std::ldexp(double(random() >> 11U), -53)});
    for (const std::uint32_t index : pen_path(points, [] { return true; }))
        path.push_back(points[index]);
    for (const double mm : {20.0, 100.0, 1000.0}) {
        const double mean = mm * path_length(path) / double(path.size());
        const double expected = usual_seconds_down(Plotter{}, mean) * double(path.size());
        EXPECT_NEAR(seconds_down(Plotter{}, path, mm) / expected, 0.95, 0.05) << mean;
    }
}

}  // namespace
}  // namespace lacuna::pen
