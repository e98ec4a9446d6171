// The way of a pen through a dot covers it, or is its edge.
#include "drawing/pen_dot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lacuna::drawing {
namespace {

// How far a place is from the middle of the pen's line, which is the least over all half circles.
double distance_to(const PenDot& dot, double x, double y) {
    double least = std::hypot(x - dot.begin(), y);
    dot.for_each_half([&](double middle, double radius, bool is_above) {
        const bool is_beside = is_above ? y >= 0 : y <= 0;
        least = std::min(least, is_beside ? std::abs(std::hypot(x - middle, y) - radius)
                                          : std::hypot(std::abs(x - middle) - radius, y));
    });
    return least;
}

TEST(APenDot, IsASpiralThatCoversTheDotAndNothingElse) {
    for (const double diameter : {1.01, 1.5, 2.0, 2.9, 3.0, 7.3, 40.0}) {
        const PenDot dot = pen_dot(diameter, 1, false);
        double length = 0;
        dot.for_each_half(
            [&](double, double radius, bool) { length += std::numbers::pi * radius; });
        EXPECT_NEAR(dot.length(), length, 1e-9 * length);
        for (int i = 0; i < 40; ++i)
            for (int angle = 0; angle < 360; angle += 7) {
                const double way = diameter / 2 * i / 39, turn = angle * std::numbers::pi / 180;
                EXPECT_LE(distance_to(dot, way * std::cos(turn), way * std::sin(turn)), 0.5 + 1e-9);
                const double outside = diameter / 2 + 0.01;
                EXPECT_GT(distance_to(dot, outside * std::cos(turn), outside * std::sin(turn)),
                          0.5);
            }
    }
}

TEST(APenDot, IsACircleWithTheDotsEdgeOrADip) {
    const PenDot circle = pen_dot(5, 1, true);
    EXPECT_NEAR(circle.length(), 4 * std::numbers::pi, 1e-12);
    EXPECT_EQ(circle.begin(), 2);
    EXPECT_EQ(circle.end(), 2);
    for (const double diameter : {0.5, 1.0}) {
        const PenDot dip = pen_dot(diameter, 1, false);
        EXPECT_EQ(dip.halves, 0);
        EXPECT_EQ(dip.length() + dip.begin() + dip.end(), 0);
    }
}

}  // namespace
}  // namespace lacuna::drawing
