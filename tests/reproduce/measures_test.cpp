// The measures of the figures, against closed forms and made sets.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "reproduce/disk_area.h"
#include "reproduce/edge.h"
#include "reproduce/picture.h"
#include "reproduce/shapes.h"
#include "reproduce/stipple.h"

namespace {

using namespace lacuna;
using namespace lacuna::reproduce;
using std::numbers::pi;

// Poisson's summation formula: the transform of a disk's chords is a Bessel function.
double area_by_bessel_functions(std::uint32_t m, double offset) {
    double area = 1;
    for (int k = 1; k < 20'000; ++k)
        area += 2 * std::cyl_bessel_j(1.0, 2 * pi * m * k) / (pi * m * k) *
                std::cos(2 * pi * k * offset);
    return area;
}

TEST(AreaByLines, IsThatOfPoissonsSummationFormula) {
    for (const std::uint32_t m : {1U, 2U, 7U, 30U})
        for (const double offset : {0.1, 0.25, 0.5, 0.9})
            EXPECT_NEAR(area_by_lines(m, offset), area_by_bessel_functions(m, offset), 1e-5)
                << m << ' ' << offset;
}

TEST(AreaByLines, OfOneLineThroughTheMiddleIsItsChord) {
    EXPECT_NEAR(area_by_lines(1, 0), 2 / pi, 1e-15);
    EXPECT_NEAR(area_by_lines(1, 0.5), 2 * std::sqrt(3) / pi, 1e-15);
}

TEST(AreaByCells, CountsTheLatticePointsInside) {
    EXPECT_NEAR(area_by_cells(1, 0, 0), 1 / pi, 1e-15);
    EXPECT_NEAR(area_by_cells(1, 0.5, 0.5), 4 / pi, 1e-15);
    EXPECT_NEAR(area_by_cells(5, 0, 0), 69 / (25 * pi), 1e-15);  // 81 with the 12 on the rim
    EXPECT_NEAR(area_by_cells(5, 0.3, 0.6), area_by_cells(5, 0.6, 0.3), 1e-15);
}

TEST(AreaByCells, IsRightOnAverage) {
    double sum = 0;
    constexpr int kSteps = 200;
    for (int i = 0; i < kSteps; ++i)
        for (int j = 0; j < kSteps; ++j)
            sum += area_by_cells(4, (i + 0.5) / kSteps, (j + 0.5) / kSteps);
    EXPECT_NEAR(sum / kSteps / kSteps, 1, 1e-3);
}

TEST(MissingAlongTheEdge, IsMostWithMaxLessWithMeanAndBelowZeroWithMin) {
    const Setting setting;
    reproduce::Work work(setting, 24);
    const Step step{0.02, 10};
    const auto missing = [&](Metric metric) { return missing_along_edge(step, metric, 8, work); };
    const Mean max = missing(Metric::max);
    const Mean mean = missing(Metric::mean);
    const Mean min = missing(Metric::min);
    EXPECT_GT(max.value, 0.1);
    EXPECT_NEAR(mean.value, 0.02, 0.06);
    EXPECT_LT(min.value, -0.05);
    for (const Mean& m : {max, mean, min}) {
        EXPECT_GT(m.error, 0);
        EXPECT_LT(m.error, 0.05);
    }
}

// A dot in the middle of each of n x n squares.
std::vector<Point> lattice(int n) {
    std::vector<Point> dots;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) dots.push_back({(i + 0.5) / n, (j + 0.5) / n});
    return dots;
}

TEST(ToneError, IsTheShareOfDotsInTheWrongSquare) {
    const Field even{1, 1, {1}};
    const Field even_in_pixels{8, 8, std::vector<double>(64, 0.3)};
    EXPECT_NEAR(tone_error(even_in_pixels, lattice(8), 4), 0, 1e-12);
    EXPECT_NEAR(tone_error(even_in_pixels, std::vector<Point>{{0.1, 0.1}}, 4), 15.0 / 16, 1e-12);
    EXPECT_NEAR(tone_error(even, std::vector<Point>{{0.1, 0.1}}, 1), 0, 1e-12);
}

TEST(ToneError, KnowsThatTheFirstRowIsTheTop) {
    const Field top_half{1, 2, {1, 0}};
    EXPECT_NEAR(tone_error(top_half, std::vector<Point>{{0.2, 0.9}}, 2), 0, 1e-12);
    EXPECT_NEAR(tone_error(top_half, std::vector<Point>{{0.2, 0.1}}, 2), 1, 1e-12);
}

TEST(Stipple, HasTheDotsAskedForInTheImagesShape) {
    const Field image{4, 2, std::vector<double>(8, 1.0)};
    const Setting setting;
    reproduce::Work work(setting, 1);
    const auto dots = stipple(image, 300, Metric::min, work, 1).points[0];
    EXPECT_EQ(dots.size(), 300U);
    EXPECT_LT(tone_error(image, dots, 4), 0.1);
    for (const Point& dot : dots) EXPECT_LT(dot.y, 0.5);
}

TEST(Shapes, AreDenseOnTheirGround) {
    const Field field = shapes(0.25);
    const auto at = [&](double x, double y) {
        return field.importance[static_cast<std::size_t>((1 - y) * field.rows) * field.columns +
                                static_cast<std::size_t>(x * field.columns)];
    };
    EXPECT_EQ(at(0.3, 0.68), 1);
    EXPECT_EQ(at(0.39, 0.2), 1);
    EXPECT_EQ(at(0.9, 0.1), 0.25);
    EXPECT_NEAR(at(0.77, 0.7), 0.5, 0.01);
}

// Keeps the image that is drawn.
class ImageOnly : public drawing::Canvas {
public:
    void line(std::span<const drawing::Position>, const drawing::Pen&, const Rectangle&) override {}
    void dots(std::span<const drawing::Position>, double, const Rectangle&) override {}
    void frame(const Rectangle&, const drawing::Pen&) override {}
    void text(drawing::Position, const std::string&, const drawing::TextStyle&) override {}
    void image(const Rectangle&, const drawing::Image& image) override { last = image; }
    std::string finish() override { return {}; }

    drawing::Image last{};
};

// Power 3, white, where ky = 0.
analysis::Spectrum with_a_line() {
    analysis::Spectrum spectrum{{1, 1, true}, {20, 20}, 1, 100, {}};
    for (int kx = 0; kx <= 20; ++kx)
        for (int ky = -20; ky <= 20; ++ky) spectrum.powers.push_back(ky == 0 && kx != 0 ? 3 : 0);
    return spectrum;
}

TEST(Periodograms, AreTurnedSoThatUniformXsLineStandsUpright) {
    ImageOnly canvas;
    draw_periodogram(canvas, {}, with_a_line(), 1, 1, Turned::yes);
    ASSERT_EQ(canvas.last.width, 21);
    ASSERT_EQ(canvas.last.height, 21);
    for (int row = 0; row < 21; ++row)
        for (int column = 0; column < 21; ++column)
            EXPECT_EQ(canvas.last.greys[static_cast<std::size_t>(row * 21 + column)],
                      column == 10 && row != 10 ? 255 : 0)
                << row << ' ' << column;
    draw_periodogram(canvas, {}, with_a_line(), 1, 1);
    EXPECT_EQ(canvas.last.greys[10 * 21], 255);
    EXPECT_EQ(canvas.last.greys[10], 0);
}

TEST(Periodograms, InBlocksShowTheMeansOfTheirFrequencies) {
    ImageOnly canvas;
    draw_periodogram(canvas, {}, with_a_line(), 1, 3);  // 21 frequencies in 7 blocks
    ASSERT_EQ(canvas.last.width, 7);
    ASSERT_EQ(canvas.last.greys.size(), 49U);
    EXPECT_EQ(canvas.last.greys[3 * 7], 85);
    EXPECT_EQ(canvas.last.greys[3], 0);
}

}  // namespace
