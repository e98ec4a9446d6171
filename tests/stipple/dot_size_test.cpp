// Dots sized by the local radius cover as much of the paper as the importance asks for.
#include "stipple/dot_size.h"
#include "stipple/coverage.h"
#include "stipple/dot_count.h"
#include "stipple/tones.h"

#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

namespace lacuna::pen {
namespace {

std::vector<Point> maximal_set(const Field& field, double scale) {
    Request request;
    request.mode = Mode::cells;
    request.field = &field;
    request.scale = scale;
    request.domain.boundary = Boundary::torus;  // a box has more dots along its edges
    return sample(request).points;
}

struct Range {
    double low;
    double high;
};

// The fraction of the middle of a band of x that lies under some dot.
double covered(const std::vector<Point>& points, const std::vector<double>& diameters, Range x) {
    constexpr int kPlaces = 300;
    const double reach = *std::max_element(diameters.begin(), diameters.end());
    std::vector<std::size_t> near;
    for (std::size_t k = 0; k < points.size(); ++k)
        if (points[k].x > x.low - reach && points[k].x < x.high + reach) near.push_back(k);
    int under = 0;
    for (int i = 0; i < kPlaces; ++i)
        for (int j = 0; j < kPlaces; ++j) {
            const Point place{std::lerp(x.low, x.high, (i + 0.5) / kPlaces),
                              std::lerp(0.1, 0.9, (j + 0.5) / kPlaces)};
            under += static_cast<int>(std::any_of(near.begin(), near.end(), [&](std::size_t k) {
                const double dx = points[k].x - place.x, dy = points[k].y - place.y;
                return 4 * (dx * dx + dy * dy) < diameters[k] * diameters[k];
            }));
        }
    return under / static_cast<double>(kPlaces * kPlaces);
}

class AnImportance : public testing::TestWithParam<double> {};

TEST_P(AnImportance, IsTheShareOfThePaperThatIsCovered) {
    const double importance = GetParam();
    const Field field{1, 1, {importance}};
    const std::vector<Point> points = maximal_set(field, 0.02 * std::sqrt(importance));
    const double share =
        covered(points, stippling::dot_diameters(points, field, {1, 1}), {0.1, 0.9});
    EXPECT_NEAR(share, importance, 0.03) << points.size() << " dots";
}

INSTANTIATE_TEST_SUITE_P(FromLightToBlack, AnImportance,
                         testing::Values(0.05, 0.2, 0.4, 0.55, 0.7, 0.8, 0.9, 1.0));

TEST_P(AnImportance, IsTheShareThatRelaxedDotsCover) {
    const double importance = GetParam();
    const Field field{1, 1, {importance}};
    RelaxOptions options;
    options.domain.boundary = Boundary::torus;
    const std::vector<Point> points =
        relax(maximal_set(field, 0.02 * std::sqrt(importance)), nullptr, options).points;
    const double share =
        covered(points, stippling::dot_diameters(points, field, {1, 1}, stippling::Spread::even),
                {0.1, 0.9});
    EXPECT_NEAR(share, importance, 0.015) << points.size() << " dots";
}

TEST(SolidBlack, HasNoGaps) {
    const Field field{1, 1, {1.0}};
    const stippling::Sizing sizing{.solid_black = true};
    const std::vector<Point> points = maximal_set(field, 0.02);
    EXPECT_GE(
        covered(points,
                stippling::dot_diameters(points, field, {1, 1}, stippling::Spread::random, sizing),
                {0.1, 0.9}),
        0.9999);
    RelaxOptions options;
    options.domain.boundary = Boundary::torus;
    const std::vector<Point> even = relax(points, nullptr, options).points;
    EXPECT_GE(
        covered(even,
                stippling::dot_diameters(even, field, {1, 1}, stippling::Spread::even, sizing),
                {0.1, 0.9}),
        0.9999);
    const Field grey{1, 1, {0.9}};
    EXPECT_EQ(stippling::dot_diameters(even, grey, {1, 1}, stippling::Spread::even, sizing),
              stippling::dot_diameters(even, grey, {1, 1}, stippling::Spread::even));
}

// Ten bands from light to dark, relaxed.
class ABandOfGrey : public testing::TestWithParam<stippling::Sizing> {};

TEST_P(ABandOfGrey, IsCoveredAsMuchAsItIsDark) {
    Field tone{10, 1, {}};
    for (int i = 1; i <= 10; ++i) tone.importance.push_back(i / 10.0);
    const Field density = stippling::density_of(tone, GetParam());
    Request request;
    request.mode = Mode::stratified;
    request.field = &density;
    request.domain.boundary = Boundary::torus;
    constexpr double kMillimetres = 150;  // the domain's side
    request.count =
        GetParam().pens
            ? static_cast<std::uint64_t>(std::lround(
                  std::accumulate(density.importance.begin(), density.importance.end(), 0.0) / 10 *
                  kMillimetres * kMillimetres))
            : 20'000;
    RelaxOptions options;
    options.domain.boundary = Boundary::torus;
    const std::vector<Point> points = relax(sample(request).points, &density, options).points;
    const std::vector<double> diameters =
        GetParam().pens
            ? stippling::pen_diameters(points, tone, {1, 1}, *GetParam().pens, kMillimetres)
            : stippling::dot_diameters(points, tone, {1, 1}, stippling::Spread::even, GetParam());
    for (int band = 0; band < 10; ++band) {
        // With pens dots are not made wider where they overlap.
        if (GetParam().pens && band > 5) break;
        const double share = covered(points, diameters, {(band + 0.25) / 10, (band + 0.75) / 10});
        EXPECT_NEAR(share, (band + 1) / 10.0, 0.02) << "dots " << points.size();
    }
}

INSTANTIATE_TEST_SUITE_P(BySize, ABandOfGrey,
                         testing::Values(stippling::Sizing{0, {}}, stippling::Sizing{0.3, {}},
                                         stippling::Sizing{0.7, {}}, stippling::Sizing{1, {}},
                                         stippling::Sizing{0, {{1.2, 1.2}}},
                                         stippling::Sizing{0, {{0.7, 1.6}}}));

TEST(DotDiameters, GivenTwoTonesSideBySideThenEachIsReproduced) {
    const Field field{2, 1, {0.95, 0.25}};
    const std::vector<Point> points = maximal_set(field, 0.025);
    const std::vector<double> diameters = stippling::dot_diameters(points, field, {1, 1});
    EXPECT_NEAR(covered(points, diameters, {0.1, 0.4}), 0.95, 0.03);
    EXPECT_NEAR(covered(points, diameters, {0.6, 0.9}), 0.25, 0.03);
}

TEST(DotDiameters, GivenALightPictureThenTheDotsAreAsLargeAsItIsDarkInAll) {
    const Field field{2, 2, {0.1, 0.3, 0.2, 0.0}};
    const std::vector<Point> points(50, Point{1.5, 0.5});
    double area = 0;
    for (const double diameter :
         stippling::dot_diameters(points, field, {2, 1}, stippling::Spread::even))
        area += std::numbers::pi / 4 * diameter * diameter;
    EXPECT_NEAR(area, 0.15 * 2 * 1, 1e-12);
}

// Dots of two tones that lie less densely in the dark than the tones ask for.
TEST(DotDiameters, OfRandomDotsCoverTheDarknessThoughTheyLieAsTheyLike) {
    const Field field{2, 1, {0.9, 0.3}};
    const std::vector<Point> points = maximal_set({1, 1, {1}}, 0.02);
    const std::vector<double> diameters = stippling::dot_diameters(points, field, {1, 1});
    EXPECT_NEAR(covered(points, diameters, {0, 1}), 0.6, 0.02);
}

TEST(CoveredArea, IsThatOfDisksAndOfTheirUnionAndWrapsOnATorus) {
    const double quarter = std::numbers::pi / 4 * 0.25;
    const auto area = [](std::vector<Point> points, double diameter, Domain domain) {
        const Ellipse disk{diameter / 2, diameter / 2, 0};
        return stippling::covered_area(points, std::vector(points.size(), disk), 1, domain);
    };
    EXPECT_NEAR(area({{0.5, 0.5}}, 0.5, {1, 1}), quarter, 1e-3);
    EXPECT_NEAR(area({{0.5, 0.5}, {0.5, 0.5}}, 0.5, {1, 1}), quarter, 1e-3);
    EXPECT_NEAR(area({{0.5, 0.5}, {1.5, 0.5}}, 0.5, {2, 1}), 2 * quarter, 2e-3);
    EXPECT_NEAR(area({{0, 0}}, 0.5, {1, 1}), quarter / 4, 1e-3);
    EXPECT_NEAR(area({{0, 0}}, 0.5, {1, 1, Boundary::torus}), quarter, 1e-3);
    EXPECT_NEAR(area({{7, 9}}, 0.5, {1, 1, Boundary::box, 6.5, 8.5}), quarter, 1e-3);
    EXPECT_EQ(area({}, 0.5, {1, 1}), 0);
    const std::vector<Point> middle{{0.5, 0.5}};
    for (const double angle : {0.0, 0.7, 2.0})
        EXPECT_NEAR(
            stippling::covered_area(middle, std::vector{Ellipse{0.2, 0.1, angle}}, 2, {1, 1}),
            std::numbers::pi * 0.4 * 0.2, 1e-3)
            << angle;
    // Half of an upright ellipse lies beyond the left edge.
    EXPECT_NEAR(
        stippling::covered_area(std::vector<Point>{{0, 0.5}},
                                std::vector{Ellipse{0.4, 0.1, std::numbers::pi / 2}}, 1, {1, 1}),
        std::numbers::pi * 0.4 * 0.1 / 2, 1e-3);
}

TEST(DotDiameters, GivenADarkTopThenDotsThereAreLargerAndYGoesUpwards) {
    const Field field{1, 2, {1.0, 0.3}};
    const std::vector<Point> points{{0.5, 0.75}, {0.5, 0.25}, {0.5, 0.999}, {0.5, 0}};
    const std::vector<double> diameters = stippling::dot_diameters(points, field, {1, 1});
    EXPECT_NEAR(diameters[0] / diameters[1], 1.3, 0.01);
    EXPECT_EQ(diameters[2], diameters[0]);
    EXPECT_EQ(diameters[3], diameters[1]);
}

TEST(DotDiameters, GivenAllTonesThenThereAreFewSizes) {
    Field field{256, 1, {}};
    std::vector<Point> points;
    for (int i = 0; i < 256; ++i) {
        field.importance.push_back(i / 255.0);
        points.push_back({(i + 0.5) / 256, 0.5});
    }
    std::vector<double> diameters = stippling::dot_diameters(points, field, {1, 1});
    EXPECT_TRUE(std::is_sorted(diameters.begin(), diameters.end()));
    diameters.erase(std::unique(diameters.begin(), diameters.end()), diameters.end());
    EXPECT_GT(diameters.size(), 10U);
    EXPECT_LT(diameters.size(), 40U);
}

// docs/stipple_measured.md, "How many": the million is of all inks together.
TEST(TheNumberOfDots, CountsASideAs512To2048PixelsAndIsAMillionAtMost) {
    const auto black = [](std::uint32_t columns) {
        return Field{columns, 1, std::vector<double>(columns, 1)};
    };
    for (const auto& [columns, counted] : {std::pair{1U, 512U}, {700U, 700U}, {4096U, 2048U}})
        EXPECT_EQ(stippling::dot_count(black(columns), {1, 1}), counted * counted / 16) << columns;
    for (const std::size_t inks : {0U, 1U, 2U}) {
        stippling::Tones tones;
        tones.sizing.pens = Pens{0.01, 0.01};
        tones.layers.resize(inks);
        tones.fields.assign(std::max<std::size_t>(1, inks), black(1));
        tones.sum = black(1);
        EXPECT_EQ(stippling::suiting_count(tones, {1, 1}, {}), 1'000'000U) << inks << " inks";
    }
}

}  // namespace
}  // namespace lacuna::pen
