// Dots of a picture that are kept off its white parts.
#include "stipple/keep_inside.h"

#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace lacuna::stippling {
namespace {

Point in_white(const White& white, std::uint32_t column, std::uint32_t row) {
    return {(column + 0.5) / white.field.columns * white.domain.width,
            (white.field.rows - row - 0.5) / white.field.rows * white.domain.height};
}

// The distance to the nearest white pixel, all of which are asked, or to the edge of a box.
double distance_to_white(Point from, const White& white) {
    const bool torus = white.domain.wraps();
    double least =
        torus
            ? INFINITY
            : std::min({from.x, white.domain.width - from.x, from.y, white.domain.height - from.y});
    const double half_x = white.domain.width / white.field.columns / 2;
    const double half_y = white.domain.height / white.field.rows / 2;
    for (std::uint32_t row = 0; row < white.field.rows; ++row)
        for (std::uint32_t column = 0; column < white.field.columns; ++column) {
            if (white.field.importance[row * white.field.columns + column] != 0) continue;
            const Point middle = in_white(white, column, row);
            const auto gap = [torus](double d, double side, double half) {
                if (torus) d = std::min(std::abs(d), side - std::abs(d));
                return std::max(0.0, std::abs(d) - half);
            };
            least =
                std::min(least, std::hypot(gap(from.x - middle.x, white.domain.width, half_x),
                                           gap(from.y - middle.y, white.domain.height, half_y)));
        }
    return least;
}

struct Dots {
    std::vector<Point> points;
    std::vector<double> diameters;
};

// Dots anywhere on dark pixels, of all sizes up to half of the picture.
Dots random_dots(const White& white, std::mt19937_64& random) {
    std::uniform_real_distribution<double> unit;
    Dots dots;
    for (int i = 0; i < 200; ++i) {
        const Point point{unit(random) * white.domain.width, unit(random) * white.domain.height};
        if (distance_to_white(point, white) == 0) continue;
        dots.points.push_back(point);
        dots.diameters.push_back(0.5 * unit(random) * unit(random));
    }
    return dots;
}

class KeepInside : public testing::TestWithParam<Boundary> {};

TEST_P(KeepInside, LeavesNoDotOnWhite) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> unit;
    std::size_t moved = 0, shrunk = 0;
    for (int i = 0; i < 60; ++i) {
        Field field{3 + static_cast<std::uint32_t>(random() % 20),
                    3 + static_cast<std::uint32_t>(random() % 20),
                    {}};
        const double share = 0.4 * unit(random);
        for (std::uint32_t k = 0; k < field.columns * field.rows; ++k)
            field.importance.push_back(unit(random) < share ? 0 : 0.1 + unit(random));
        const White white{field, {1, 0.5 + unit(random), GetParam()}};
        const Dots before = random_dots(white, random);
        Dots dots = before;
        pull_inside(dots.points, dots.diameters, white);
        fit_inside(dots.points, dots.diameters, white);
        for (std::size_t k = 0; k < dots.points.size(); ++k) {
            const double distance = distance_to_white(dots.points[k], white);
            ASSERT_GE(distance, dots.diameters[k] / 2 * (1 - 1e-9));
            // Whoever had room has neither moved nor shrunk, and nobody is worse off.
            const double had = distance_to_white(before.points[k], white);
            ASSERT_GE(distance, had * (1 - 1e-9));
            if (had >= before.diameters[k] / 2) {
                ASSERT_EQ(dots.points[k].x, before.points[k].x);
                ASSERT_EQ(dots.diameters[k], before.diameters[k]);
            }
            moved += static_cast<std::size_t>(dots.points[k].x != before.points[k].x);
            shrunk += static_cast<std::size_t>(dots.diameters[k] < before.diameters[k]);
        }
    }
    EXPECT_GT(moved, 1000U);
    EXPECT_GT(shrunk, 500U);
    EXPECT_LT(shrunk, moved);
}

INSTANTIATE_TEST_SUITE_P(Boundaries, KeepInside, testing::Values(Boundary::box, Boundary::torus),
                         [](const auto& of) {
                             return of.param == Boundary::box ? "Box" : "Torus";
                         });

// The left half is dark.
const Field kHalf{2, 1, {1, 0}};
const White kHalfWhite{kHalf, {1, 1}};

TEST(KeepInsideDots, MoveAsFarAsTheyOverhang) {
    std::vector<Point> points{{0.46, 0.5}, {0.3, 0.97}, {0.2, 0.5}};
    pull_inside(points, std::vector<double>{0.1, 0.1, 0.1}, kHalfWhite);
    EXPECT_NEAR(points[0].x, 0.45, 1e-4);
    EXPECT_EQ(points[0].y, 0.5);
    EXPECT_NEAR(points[1].y, 0.95, 1e-4);
    EXPECT_EQ(points[2].x, 0.2);
}

TEST(KeepInsideDots, ComeToTheMiddleOfANarrowShapeAndShrink) {
    std::vector<Point> points{{0.1, 0.5}};
    std::vector<double> diameters{0.8};
    pull_inside(points, diameters, kHalfWhite);
    EXPECT_NEAR(points[0].x, 0.25, 0.01);
    fit_inside(points, diameters, kHalfWhite);
    EXPECT_NEAR(diameters[0], 0.5, 0.02);
}

TEST(KeepInsideDots, OfAPenDoNotShrinkBelowIt) {
    std::vector<double> diameters{0.8, 0.2};
    fit_inside(std::vector<Point>{{0.25, 0.5}, {0.25, 0.5}}, diameters, kHalfWhite, 0.6);
    EXPECT_EQ(diameters, (std::vector<double>{0.6, 0.2}));
}

TEST(KeepInsideDots, OnTheEdgeOfWhiteMoveOffIt) {
    std::vector<Point> points{{0.5, 0.5}, {0, 0.5}, {0.25, 0}};
    // The first lies on the edge of the white half, the others on the edges of the picture.
    points[0].x = std::nextafter(0.5, 0);
    const std::vector<double> diameters{0.1, 0.1, 0.1};
    pull_inside(points, diameters, kHalfWhite);
    EXPECT_LE(points[0].x, 0.45);
    EXPECT_GE(points[1].x, 0.05);
    EXPECT_GE(points[2].y, 0.05);
    std::vector<double> fitted = diameters;
    fit_inside(points, fitted, kHalfWhite);
    EXPECT_EQ(fitted, diameters);
}

// A triangle, whose tip is narrower than any dot.
TEST(KeepInsideDots, DoNotMeetOnOneSpot) {
    constexpr std::uint32_t kSide = 64;
    Field field{kSide, kSide, std::vector<double>(kSide * kSide, 0)};
    for (std::uint32_t row = 0; row < kSide; ++row)
        for (std::uint32_t column = 0; column < kSide; ++column)
            if (column >= kSide / 2 - row / 4 - 1 && column <= kSide / 2 + row / 4)
                field.importance[row * kSide + column] = 1;
    for (const Boundary boundary : {Boundary::box, Boundary::torus}) {
        const White white{field, {1, 1, boundary}};
        std::mt19937_64 random(1);
        std::uniform_real_distribution<double> unit;
        std::vector<Point> before;
        while (before.size() < 400) {
            const Point point{unit(random), unit(random)};
            if (distance_to_white(point, white) > 0) before.push_back(point);
        }
        const std::vector<double> diameters(before.size(), 0.08);
        std::vector<Point> after = before;
        pull_inside(after, diameters, white);
        const auto distance = [](Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); };
        std::size_t came_nearer = 0;
        for (std::size_t i = 0; i < after.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const double now = distance(after[i], after[j]);
                const double was = distance(before[i], before[j]);
                came_nearer += static_cast<std::size_t>(now < was);
                ASSERT_GE(now, 0.999 * std::min(was, 0.125 * 0.08)) << i << " " << j;
            }
        EXPECT_GT(came_nearer, 1000U);
    }
}

TEST(KeepInsideDots, ThatBeganOnWhiteStayThere) {
    std::vector<Point> points{{0.75, 0.5}};
    pull_inside(points, std::vector<double>{0.2}, kHalfWhite);
    EXPECT_EQ(points[0].x, 0.75);
}

// Rounding may put a dot on a corner of its pixel beside it, on white.
TEST(KeptInside, ADotOnACornerOfItsPixelHasASize) {
    for (std::uint32_t pixels = 3; pixels < 40; ++pixels) {
        Field field{
            .columns = pixels, .rows = pixels, .importance = std::vector<double>(pixels * pixels)};
        const White white{field, {.width = 1, .height = 13. / 14}};
        for (std::uint32_t i = 1; i + 1 < pixels; ++i) {
            field.importance.assign(pixels * pixels, 0);
            field.importance[i * pixels + i] = 1;
            for (const double right : {-0.5, 0.5})
                for (const double up : {-0.5, 0.5}) {
                    const Point middle = in_white(white, i, i);
                    std::vector<Point> points{{middle.x + right * white.domain.width / pixels,
                                               middle.y + up * white.domain.height / pixels}};
                    std::vector<double> diameters{1. / pixels};
                    pull_inside(points, diameters, white);
                    fit_inside(points, diameters, white);
                    ASSERT_GT(diameters[0], 0) << i << " of " << pixels;
                }
        }
    }
}

}  // namespace
}  // namespace lacuna::stippling
