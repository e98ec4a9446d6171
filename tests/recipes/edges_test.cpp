// The edges of stippled pictures: dots near them lie as they do anywhere else in the picture.
#include <gtest/gtest.h>
#include <lacuna/stipple.h>
#include <lacuna/verify.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "recipes/make.h"

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
// whose traces depend on their number: so sets of several numbers are made. Without a margin the
// first two rings have 0 and 2.5.
template <class Dots>
void expect_no_rows(const Dots& make_dots) {
    constexpr std::size_t kSets = 8;
    Profile mean{};
    for (std::size_t i = 0; i < kSets; ++i) {
        const Profile one = profile_of(make_dots(kDots + 150 * i));
        for (std::size_t k = 0; k < kRings; ++k) mean[k] += one[k] / kSets;
    }
    for (std::size_t k = 0; k < kRings; ++k) {
        EXPECT_GT(mean[k], 0.8) << "ring " << k;
        EXPECT_LT(mean[k], 1.25) << "ring " << k;
    }
}

TEST(Edges, OfAGreyPictureHaveNoRowsOfDots) {
    const Field field = grey(100, 100);
    expect_no_rows([&](std::size_t dots) {
        const Stippling made = stippled(field, with_dots(dots));
        EXPECT_EQ(made.result.points.size(), dots);
        return made.result.points;
    });
}

TEST(Edges, OfInksHaveNoRowsOfDots) {
    const Field field = grey(100, 100);
    expect_no_rows([&](std::size_t dots) {
        StippleOptions options;
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
    expect_no_rows([&](std::size_t dots) {
        StippleOptions options = with_dots(dots);
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

// A dark ball of a tenth of the width that moves by nearly its width from picture to picture.
TEST(Frames, LetAShapeThatGoesFastKeepItsDots) {
    constexpr double kRadius = 0.05;
    StippleOptions options = with_dots(kDots);
    const double spacing = 1 / std::sqrt(static_cast<double>(kDots));
    for (int frame = 0; frame < 8; ++frame) {
        Field field = grey(200, 200, 0.2);
        const double x = 0.15 + 0.08 * frame;
        double inside = 0, all = 0;
        for (std::uint32_t row = 0; row < field.rows; ++row)
            for (std::uint32_t column = 0; column < field.columns; ++column) {
                double& one = field.importance[row * field.columns + column];
                const bool is_ball =
                    std::hypot((column + 0.5) / 200 - x, (row + 0.5) / 200 - 0.5) < kRadius;
                if (is_ball) one = 1;
                inside += is_ball ? one : 0;
                all += one;
            }
        const std::vector<Point> dots = stippled(field, options).result.points;
        const auto in_ball = std::count_if(dots.begin(), dots.end(), [&](const Point& dot) {
            return std::hypot(dot.x - x, dot.y - 0.5) < kRadius;
        });
        const double fair = inside / all * static_cast<double>(kDots);
        EXPECT_NEAR(static_cast<double>(in_ball), fair, 0.2 * fair) << "frame " << frame;
        const double least = least_distance(dots, {1, 1});
        EXPECT_GT(least, 0.15 * spacing) << "frame " << frame;
        options.start_points = dots;
    }
}

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
    return recipes::make(request, {.iterations = made.iterations}, nobody).result.points;
}

TEST(Edges, AreClosedWithFewDotsOnATorusAndIfDotsAreKeptInside) {
    const Field field = grey(40, 30);
    const auto is_alone = [&](const StippleOptions& options) {
        const Stippling made = stippled(field, options);
        return made.result.points == alone(field, made);
    };
    EXPECT_TRUE(is_alone(with_dots(100)));
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
