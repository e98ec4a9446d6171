// The edges of stippled pictures: dots near them lie as they do anywhere else in the picture.
#include <gtest/gtest.h>
#include <lacuna/stipple.h>
#include <lacuna/verify.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "options/make.h"

namespace lacuna {
namespace {

constexpr std::size_t kDots = 2000;

Field grey(std::uint32_t columns, std::uint32_t rows, double importance = 0.5) {
    return {columns, rows, std::vector<double>(std::size_t{columns} * rows, importance)};
}

StippleOptions with_dots(std::uint64_t dots, std::uint64_t seed = 0) {
    StippleOptions options;
    options.request.count = dots;
    options.request.seed = seed;
    return options;
}

Stippling stippled(const Field& field, const StippleOptions& options) {
    Observer nobody;
    return stipple({field}, options, nobody);
}

// How many dots lie in rings along the edges of an even square, each a quarter of the mean spacing
// wide, over how many there would be if they were spread evenly.
constexpr std::size_t kRings = 8;
using Profile = std::array<double, kRings>;
Profile profile_of(std::span<const Point> dots) {
    const double spacing = 1 / std::sqrt(static_cast<double>(dots.size()));
    const double width = spacing / 4;
    Profile profile{};
    for (const Point& dot : dots) {
        const double depth = std::min({dot.x, 1 - dot.x, dot.y, 1 - dot.y});
        const auto ring = static_cast<std::size_t>(depth / width);
        if (ring < kRings) profile[ring] += 1;
    }
    for (std::size_t k = 0; k < kRings; ++k) {
        const double outer = 1 - 2 * width * static_cast<double>(k), inner = outer - 2 * width;
        profile[k] /= (outer * outer - inner * inner) * static_cast<double>(dots.size());
    }
    return profile;
}

// The mean of profiles, whose rings have about 700 dots each. Dots begin along a Hilbert curve,
// whose traces depend on their number: so sets of several numbers and seeds are made. Without a
// margin the first two rings have 0 and 2.5.
template <class Dots>
void expect_no_rows(const Dots& make_dots) {
    constexpr std::size_t kSets = 8;
    Profile mean{};
    for (std::size_t i = 0; i < kSets; ++i) {
        const Profile one = profile_of(make_dots(with_dots(kDots + 150 * i, i)));
        for (std::size_t k = 0; k < kRings; ++k) mean[k] += one[k] / kSets;
    }
    for (std::size_t k = 0; k < kRings; ++k) {
        EXPECT_GT(mean[k], 0.8) << "ring " << k;
        EXPECT_LT(mean[k], 1.25) << "ring " << k;
    }
}

TEST(Edges, OfAGreyPictureHaveNoRowsOfDots) {
    const Field field = grey(100, 100);
    expect_no_rows([&](const StippleOptions& options) {
        const Stippling made = stippled(field, options);
        EXPECT_EQ(made.result.points.size(), *options.request.count);
        return made.result.points;
    });
}

// The edges are lighter than most of the picture, so dots there are far apart.
TEST(Edges, ThatAreLightHaveNoRowsOfDotsEither) {
    Field field = grey(100, 100, 0.05);
    for (std::uint32_t row = 20; row < 80; ++row)
        for (std::uint32_t column = 20; column < 80; ++column)
            field.importance[row * field.columns + column] = 1;
    // A quarter of a spacing of dots along the edges, and the dots in such rings.
    const double width = std::sqrt((36 + 64 * 0.05) / (100 * 0.05 * 4 * kDots)) / 4;
    std::array<double, 4> rings{};
    for (std::size_t i = 0; i < 8; ++i)
        for (const Point& dot : stippled(field, with_dots(4 * kDots + 150 * i, i)).result.points) {
            const double depth = std::min({dot.x, 1 - dot.x, dot.y, 1 - dot.y});
            const auto ring = static_cast<std::size_t>(depth / width);
            if (ring < rings.size()) rings[ring] += 1;
        }
    const double mean = (rings[0] + rings[1] + rings[2] + rings[3]) / 4;
    for (const double ring : rings) {
        EXPECT_GT(ring, 0.7 * mean);
        EXPECT_LT(ring, 1.45 * mean);
    }
}

TEST(Edges, OfInksHaveNoRowsOfDots) {
    const Field field = grey(100, 100);
    expect_no_rows([&](StippleOptions options) {
        const std::uint64_t dots = *std::exchange(options.request.count, std::nullopt);
        options.inks = inks_of("red,blue");
        options.ink_counts = {dots, dots};
        Observer nobody;
        const Stippling made = stipple({field, field}, options, nobody);
        EXPECT_EQ(made.layers[0].dots, dots);
        EXPECT_EQ(made.result.points.size(), 2 * dots);
        return std::vector<Point>(made.result.points.begin(),
                                  made.result.points.begin() + static_cast<std::ptrdiff_t>(dots));
    });
}

TEST(Edges, OfAFrameHaveNoRowsAfterManyPictures) {
    const Field field = grey(100, 100);
    expect_no_rows([&](StippleOptions options) {
        for (int frame = 0; frame < 5; ++frame)
            options.start_points = stippled(field, options).result.points;
        return options.start_points;
    });
}

TEST(Edges, LetDotsOfAStillPictureStayWhereTheyAre) {
    StippleOptions options = with_dots(kDots);
    const Field field = grey(100, 100);
    for (int frame = 0; frame < 2; ++frame)
        options.start_points = stippled(field, options).result.points;
    const std::vector<Point> moved = stippled(field, options).result.points;
    std::vector<double> ways;
    for (std::size_t i = 0; i < kDots; ++i)
        ways.push_back(std::hypot(moved[i].x - options.start_points[i].x,
                                  moved[i].y - options.start_points[i].y));
    std::sort(ways.begin(), ways.end());
    const double spacing = 1 / std::sqrt(static_cast<double>(kDots));
    EXPECT_LT(ways[kDots / 2], 0.1 * spacing);
    EXPECT_LT(ways[kDots * 99 / 100], 0.6 * spacing);
}

// A black ball of a fifth of the width on light paper, which moves by half of its width from
// picture to picture, and back.
class Ball : public testing::TestWithParam<double> {};

TEST_P(Ball, ThatGoesFastKeepsItsDotsAndNoTwoLieOnEachOther) {
    constexpr double kRadius = 0.1;
    StippleOptions options = with_dots(kDots);
    for (int frame = 0; frame < 24; ++frame) {
        Field field = grey(200, 200, GetParam());
        const double x = 0.15 + 0.1 * (frame % 14 < 7 ? frame % 14 : 14 - frame % 14);
        const auto is_in_ball = [&](double at_x, double at_y) {
            return std::hypot(at_x - x, at_y - 0.5) < kRadius;
        };
        double inside = 0, all = 0;
        for (std::uint32_t row = 0; row < field.rows; ++row)
            for (std::uint32_t column = 0; column < field.columns; ++column) {
                double& one = field.importance[row * field.columns + column];
                const bool is_ball = is_in_ball((column + 0.5) / 200, (row + 0.5) / 200);
                if (is_ball) one = 1;
                inside += is_ball ? one : 0;
                all += one;
            }
        const std::vector<Point> dots = stippled(field, options).result.points;
        const auto in_ball = std::count_if(dots.begin(), dots.end(),
                                           [&](Point dot) { return is_in_ball(dot.x, dot.y); });
        const double fair = inside / all * static_cast<double>(kDots);
        EXPECT_NEAR(static_cast<double>(in_ball), fair, 0.2 * fair) << "frame " << frame;
        const double spacing = std::sqrt(std::numbers::pi * kRadius * kRadius / fair);
        EXPECT_GT(least_distance(dots, {1, 1}), 0.1 * spacing) << "frame " << frame;
        options.start_points = dots;
    }
}

INSTANTIATE_TEST_SUITE_P(Frames, Ball, testing::Values(0.0, 0.04, 0.3));

// A bar across the upper edge, and a frame two pixels from the others.
TEST(Edges, PutNoDotIntoWhite) {
    Field field = grey(120, 120, 0);
    const auto is_black = [](std::uint32_t column, std::uint32_t row) {
        const bool is_bar = column >= 40 && column < 44 && row < 50;
        const std::uint32_t edge = std::min({column, row, 119 - column, 119 - row});
        return is_bar || (edge >= 2 && edge < 5);
    };
    for (std::uint32_t row = 0; row < field.rows; ++row)
        for (std::uint32_t column = 0; column < field.columns; ++column)
            field.importance[row * field.columns + column] = is_black(column, row) ? 1 : 0;
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        const Stippling made = stippled(field, with_dots(1000, seed));
        ASSERT_EQ(made.result.points.size(), 1000U);
        for (const Point& dot : made.result.points)
            EXPECT_TRUE(is_black(static_cast<std::uint32_t>(dot.x * 120),
                                 static_cast<std::uint32_t>((1 - dot.y) * 120)))
                << dot.x << " " << dot.y;
    }
}

// The dots of a picture without a margin.
std::vector<Point> alone(const Field& field, const Stippling& made) {
    Request request = made.request;
    request.field = &field;
    Observer nobody;
    return options::make(request, {.iterations = made.iterations}, nobody).result.points;
}

TEST(Edges, AreClosedWithFewDotsOnATorusAndIfDotsAreKeptInside) {
    const Field field = grey(40, 30);
    const auto is_alone = [&](const StippleOptions& options) {
        const Stippling made = stippled(field, options);
        return made.result.points == alone(field, made);
    };
    EXPECT_TRUE(is_alone(with_dots(20)));
    EXPECT_FALSE(is_alone(with_dots(100)));
    EXPECT_FALSE(is_alone(with_dots(1000)));
    StippleOptions options = with_dots(1000);
    options.request.domain.boundary = Boundary::torus;
    EXPECT_TRUE(is_alone(options));
    options = with_dots(1000);
    options.relax = 0;
    EXPECT_TRUE(is_alone(options));
    options.relax = 5;
    EXPECT_FALSE(is_alone(options));
    options.keep_inside = true;
    const std::vector<Point> kept = stippled(field, options).result.points;
    EXPECT_TRUE(std::none_of(kept.begin(), kept.end(), [](const Point& dot) {
        return std::min({dot.x, 1 - dot.x, dot.y, 0.75 - dot.y}) < 0.005;
    }));
}

}  // namespace
}  // namespace lacuna
