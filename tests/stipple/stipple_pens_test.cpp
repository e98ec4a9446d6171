// lacuna::stipple for plotters: pens, times, strokes and lines.
#include <gtest/gtest.h>
#include <lacuna/stipple.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "refusal.h"
#include "stipple/dot_size.h"
#include "stipple/stippled_pictures.h"

namespace lacuna {
namespace {

using namespace tests::stippled;
using tests::refusal_of;

// The length of a unit of the picture on its paper.
double mm_of(const Stippling& made) {
    const auto& [width, height, margin, may_turn] = *made.paper;
    const Domain& domain = made.request.domain;
    return std::min((width - 2 * margin) / domain.width, (height - 2 * margin) / domain.height);
}

TEST(Stippling, ForAPenHasTheSameDotsOfEachInkOnAShortPath) {
    StippleOptions options = in_inks("red,black,blue", 300);
    const Stippling placed = stipple(kDrawing, options);
    options.pen_path = true;
    const Stippling path = stipple(kDrawing, options);
    EXPECT_EQ(dots_of(path), dots_of(placed));
    std::size_t first = 0;
    for (const Layer& layer : path.layers) {
        EXPECT_EQ(sorted(std::span(path.result.points).subspan(first, layer.dots)),
                  sorted(std::span(placed.result.points).subspan(first, layer.dots)));
        first += layer.dots;
    }
    EXPECT_LT(path.path_length, path.admitted_length);
}

TEST(Stippling, OfPensIsOnAShortPathUnlessThatIsNotWanted) {
    const StippleOptions plain = counted(200), inks = in_inks("red:0.5mm,blue:1mm", 200);
    StippleOptions pen = plain, pens = plain, strokes = plain, pen_of_inks = in_inks("red", 200);
    pen.pens = pen_of_inks.pens = Pens{1, 1};
    pens.pens = Pens{1, 2, {1, 2}};
    strokes.pens = Pens{1, 1};
    strokes.tone.along = 4;
    for (StippleOptions options : {plain, in_inks("red", 200)})
        EXPECT_FALSE(stipple(kDrawing, options).is_for_a_pen);
    for (StippleOptions options : {pen, pens, strokes, inks, pen_of_inks}) {
        const Stippling path = stipple(kDrawing, options);
        EXPECT_TRUE(path.is_for_a_pen);
        EXPECT_LT(path.path_length, path.admitted_length);
        options.pen_path = false;
        const Stippling made = stipple(kDrawing, options);
        EXPECT_FALSE(made.is_for_a_pen);
        EXPECT_GT(made.path_length, path.path_length);
        if (!made.are_strokes) {
            EXPECT_EQ(sorted(made.result.points), sorted(path.result.points));
        }
    }
    StippleOptions line = pen;
    line.path_line = true;
    line.pen_path = false;
    EXPECT_EQ(refusal_of([&] { stipple(kDrawing, line); }),
              "no-pen-path with --path-line: dots then come in the order of a path");
}

TEST(Stippling, ForATimeIsDrawnInAtMostThatTimeAndNotMuchLess) {
    const StippleOptions dots{.paper = Paper{200, 200, 10}};
    StippleOptions inks = dots, line = dots, lines = dots, pens = dots, strokes = dots;
    pens.pens = Pens{0.5, 1.2, {0.5, 0.8, 1.2}};
    inks.inks = lines.inks = inks_of("red,black,blue");
    line.path_line = lines.path_line = true;
    strokes.tone.along = 4;
    strokes.pens = Pens{2, 2};
    const std::vector<Plotter> plotters{{}, {0, 40, 30, 0}, {0.1, 40, 20, 0.3}};
    const auto expect = [](const StippleOptions& options, double least) {
        const int step = options.pens.value_or(Pens{}).widths_mm.empty() ? 1 : 37;
        const Stippling made = stipple(options.inks.empty() ? ramp(step) : kDrawing, options);
        EXPECT_TRUE(made.is_for_a_pen);
        EXPECT_FALSE(made.is_finished_sooner);
        EXPECT_LE(made.plot_seconds, *options.plot_seconds);
        EXPECT_GE(made.plot_seconds, least * *options.plot_seconds);
    };
    for (StippleOptions options : {dots, inks, line, lines, pens})
        for (const Plotter& plotter : plotters) {
            SCOPED_TRACE(options.path_line ? "line" : "dots");
            SCOPED_TRACE(plotter.seconds_per_corner);
            options.plotter = plotter;
            options.plot_seconds = 100;
            expect(options, 0.9);
        }
    strokes.plot_seconds = 600;
    expect(strokes, 0.8);
    // Long strokes are further apart than dots, and those that cross are longer.
    strokes.paper = Paper{400, 400, 10};
    strokes.plot_seconds = 2000;
    expect(strokes, 0.8);
}

TEST(Stippling, WithTimeForMoreThanThePictureNeedsHasWhatItNeeds) {
    const StippleOptions dots{.pens = Pens{1, 1}, .paper = Paper{60, 60}};
    StippleOptions line = dots, strokes = dots, inks = dots, pens = dots;
    line.path_line = true;
    strokes.tone.along = 4;
    inks.inks = inks_of("red:1mm,black:0.6mm");
    pens.pens = Pens{0.5, 1, {0.5, 1}};
    for (StippleOptions options : {dots, line, strokes, inks, pens}) {
        const Picture& picture = options.inks.empty() ? ramp() : kDrawing;
        const Stippling needed = stipple(picture, options);
        EXPECT_FALSE(needed.is_finished_sooner);
        options.plot_seconds = 100 * 3600;
        const Stippling made = stipple(picture, options);
        EXPECT_TRUE(made.is_finished_sooner);
        EXPECT_EQ(made.result.points, needed.result.points);
        EXPECT_EQ(made.plot_seconds, needed.plot_seconds);
    }
    // The time of dots: what lowering the pen takes, and the ways between them.
    const Stippling made = stipple(ramp(), dots);
    EXPECT_GT(made.plot_seconds, 0.28 * double(made.result.points.size()));
    EXPECT_LT(made.plot_seconds, 0.45 * double(made.result.points.size()));
}

TEST(Stippling, WithPensHasTheirWidthsAndALayerForEach) {
    StippleOptions options{
        .pens = Pens{0.3, 0.8, {0.3, 0.5, 0.8}}, .paper = Paper{60, 60}, .pen_path = true};
    const Field field = importance_of(ramp(), {});
    const Stippling made = stipple(ramp(), options);
    ASSERT_EQ(made.layers.size(), 3U);
    EXPECT_EQ(made.layers[0].ink.name, "0.3mm");
    EXPECT_EQ(made.layers[2].ink.pen_mm, 0.8);
    std::size_t first = 0;
    double area = 0;
    for (const Layer& layer : made.layers) {
        for (std::size_t i = first; i < first + layer.dots; ++i) {
            EXPECT_NEAR(mm_of(made) * made.diameters[i], layer.ink.pen_mm, 1e-12);
            // The nearest width to that of the tone, which falls from 0.8 to 0.3 mm.
            const auto column = static_cast<std::size_t>(64 * made.result.points[i].x);
            const double wanted = 0.3 + 0.5 * field.importance[std::min<std::size_t>(column, 63)];
            EXPECT_LE(std::abs(wanted - layer.ink.pen_mm), 0.15 + 1e-9);
            area += 3.14159265 / 4 * layer.ink.pen_mm * layer.ink.pen_mm;
        }
        first += layer.dots;
    }
    EXPECT_EQ(first, made.result.points.size());
    // Half of the widest pen is free around the picture. Where dots overlap there are more: in
    // black 1.12^2 times as many.
    EXPECT_NEAR(mm_of(made), 60 - 0.8, 1e-9);
    area /= mm_of(made) * mm_of(made) * mean_of(field);
    EXPECT_GT(area, 1.03);
    EXPECT_LT(area, 1.12 * 1.12);
    ASSERT_EQ(made.layer_plots.size(), 3U);
    EXPECT_NEAR(
        made.layer_plots[0].seconds + made.layer_plots[1].seconds + made.layer_plots[2].seconds,
        made.plot_seconds, 1e-9);
    options.inks = inks_of("red,blue");
    EXPECT_EQ(stipple(kDrawing, options).layers[3].ink.name, "blue 0.3mm");
}

TEST(Stippling, OfOnePenHasTheTimeAndTheLengthOfItsSpiralsAndCircles) {
    const StippleOptions dots{.pens = Pens{0.5, 2}, .paper = Paper{100, 100}};
    StippleOptions spirals = dots, circles = dots, few{.paper = Paper{100, 100}};
    spirals.pen_mm = circles.pen_mm = few.pen_mm = 0.4;
    circles.circles = true;
    few.size_by_tone = 0.5;
    few.request.count = 300;
    const Stippling dips = stipple(ramp(), dots), filled = stipple(ramp(), spirals);
    EXPECT_EQ(filled.result.points, dips.result.points);
    double length = 0, ink = 0;
    for (const double diameter : filled.diameters) {
        length += std::numbers::pi * (mm_of(filled) * diameter - 0.4);
        ink += std::numbers::pi / 4 * std::pow(mm_of(filled) * diameter, 2);
    }
    const Stippling round = stipple(ramp(), circles);
    EXPECT_NEAR(mm_of(round) * (round.path_length - dips.path_length), length, 0.1 * length);
    EXPECT_GT(mm_of(filled) * (filled.path_length - dips.path_length), ink / 0.4);
    EXPECT_LT(mm_of(filled) * (filled.path_length - dips.path_length), 1.5 * ink / 0.4);
    EXPECT_GT(filled.plot_seconds, round.plot_seconds);
    EXPECT_GT(round.plot_seconds, dips.plot_seconds + 0.02 * length);
    const Stippling fine = stipple(ramp(), few);
    EXPECT_TRUE(fine.is_for_a_pen);
    EXPECT_GE(mm_of(fine) * *std::min_element(fine.diameters.begin(), fine.diameters.end()), 0.399);
    for (StippleOptions options : {spirals, circles, few}) {
        options.request.count.reset();
        options.plot_seconds = options.pens ? 250 : 800;
        const Stippling made = stipple(ramp(), options);
        EXPECT_LE(made.plot_seconds, *options.plot_seconds);
        EXPECT_GE(made.plot_seconds, 0.8 * *options.plot_seconds);
    }
}

TEST(Stippling, InInksWithPensOfTheirOwnHasAsMuchInkOfEachAsThePictureNeeds) {
    // The picture is 80 mm wide, and around it half of the widest pen is free.
    const auto dots = [](const char* inks, double widest) {
        return dots_of(
            stipple(kDrawing, {.inks = inks_of(inks), .paper = Paper{80 + widest, 60 + widest}}));
    };
    const auto thin = dots("red:0.5mm,blue:0.5mm", 0.5), mixed = dots("red:0.5mm,blue:1mm", 1);
    EXPECT_NEAR(double(mixed[0]), double(thin[0]), 2);
    EXPECT_NEAR(4 * double(mixed[1]), double(thin[1]), 4);
    const Stippling made =
        stipple(kDrawing, {.inks = inks_of("red:0.5mm,blue:1mm"), .paper = Paper{80, 60}});
    EXPECT_NEAR(mm_of(made) * made.diameters.front(), 0.5, 1e-12);
    EXPECT_NEAR(mm_of(made) * made.diameters.back(), 1, 1e-12);
}

TEST(Stippling, AlongEdgesWithAPenHasStrokesOfItsWidthAndInkForWhereTheyCross) {
    StippleOptions options{.tone = {.along = 5}, .pens = Pens{0.5, 0.5}, .paper = Paper{100, 100}};
    Field layers = importance_of(ramp(), {});
    for (double& one : layers.importance)
        one = stippling::Sizing{.are_strokes = true}.layers_at(one);
    EXPECT_GT(mean_of(layers), 1.1 * mean_of(importance_of(ramp(), {})));
    for (const std::uint64_t count : {0U, 500U}) {
        if (count != 0) options.request.count = count;
        const Stippling made = stipple(ramp(), options);
        ASSERT_TRUE(made.are_strokes);
        const double mm = mm_of(made);
        double area = 0;
        for (const Ellipse& stroke : made.ellipses) {
            EXPECT_NEAR(2 * mm * stroke.b, 0.5, 1e-12);
            EXPECT_GE(stroke.a, stroke.b);
            area += 2 * mm * (stroke.a - stroke.b) * 0.5 + 3.14159265 / 4 * 0.25;
        }
        // Few strokes are long: they cross more, and more of them are cut at the picture's edges.
        EXPECT_LE(area / (mm * mm * mean_of(layers)), count == 0 ? 1.02 : 1.5);
        EXPECT_GE(area / (mm * mm * mean_of(layers)), count == 0 ? 0.98 : 0.88);
        EXPECT_GT(mm * made.path_length,
                  2 * (area - 3.14159265 / 16 * double(made.ellipses.size())));
        // The ramp's edges go up, and so do the strokes.
        EXPECT_NEAR(std::abs(std::sin(made.ellipses.front().angle)), 1, 0.1);
    }
    EXPECT_EQ(refusal_of([&] {
                  options.request.count.reset();
                  options.plot_seconds = 5;
                  stipple(ramp(), options);
              }),
              "plot-time 5 s: the strokes alone take 4 min: give a wider --dot-size");
}

TEST(Stippling, AsALineHasInkForThePictureAndForWhereItLiesOnItself) {
    // Black at the left, half of its darkness at the right: less than a quarter as many dots there.
    const Picture halves{"P2 2 1 255 0 128", "halves"};
    const double half = importance_of(halves, {}).importance[1];
    EXPECT_NEAR(half, 0.5, 0.005);
    StippleOptions options = counted(2000);
    options.path_line = true;
    const Stippling made = stipple(halves, options);
    EXPECT_TRUE(made.is_for_a_pen);
    const auto left = std::count_if(made.result.points.begin(), made.result.points.end(),
                                    [](const Point& point) { return point.x < 0.5; });
    constexpr double kLayers = 1.2;  // of black, because the line lies on itself there
    EXPECT_NEAR(double(left), 2000 / (1 + half * half / (kLayers * kLayers)), 8);
    EXPECT_NEAR(made.line_width * made.path_length, (kLayers + half) / 2 * 0.5, 1e-12);
    // It takes longer than at full speed, and less than with a stop at each dot.
    const double metres = made.path_length * 512 / 72 * 0.0254;
    EXPECT_GT(made.plot_seconds, 1.4 * 20 * metres);
    EXPECT_LT(made.plot_seconds, 2 * std::sqrt(0.02 * 0.066 * 1000 * metres * 2000));
    // With a pen the length is what it needs.
    options = {.pens = Pens{0.5, 0.5}, .paper = Paper{100.5, 50.5}, .path_line = true};
    const Stippling drawn = stipple(halves, options);
    EXPECT_NEAR(100 * drawn.line_width, 0.5, 1e-12);
    EXPECT_NEAR(100 * 100 * drawn.line_width * drawn.path_length, 0.85 * 5000, 0.04 * 4250);
    const std::string path = testing::TempDir() + "lacuna_" + std::to_string(::getpid()) + ".svg";
    write_stippling(path, drawn);
    std::ifstream file(path);
    const std::string svg{std::istreambuf_iterator<char>(file), {}};
    EXPECT_EQ(svg.find("<path"), svg.rfind("<path")) << "one line";
    EXPECT_NE(svg.find("stroke-width=\"0.5\""), std::string::npos);
}

TEST(Stippling, OnDarkPaperInInksWithSeveralPensCoversWhatEachInkIsNeededFor) {
    StippleOptions options{.pens = Pens{0.4, 0.8, {0.4, 0.8}},
                           .paper = Paper{60, 60},
                           .paper_colour = {0, 0, 0},
                           .plot_seconds = 600};
    options.inks = inks_of("white,gold=#d4af37");
    const Stippling made = stipple(ramp(), options);
    ASSERT_EQ(made.layers.size(), 4U);
    EXPECT_EQ(made.layers[0].ink.name, "white 0.4mm");
    EXPECT_EQ(made.layers[3].ink.name, "gold 0.8mm");
    EXPECT_NEAR(made.plot_seconds, 570, 30);
    // Where the ramp is dark, so is the paper.
    for (const Point& dot : made.result.points) EXPECT_GT(dot.x, 0.02);
    std::size_t i = 0;
    double ink = 0, right = 0;
    for (const Layer& layer : made.layers)
        for (std::size_t k = 0; k < layer.dots; ++k, ++i) {
            EXPECT_NEAR(mm_of(made) * made.diameters[i], layer.ink.pen_mm, 1e-12);
            ink += layer.ink.pen_mm * layer.ink.pen_mm;
            if (made.result.points[i].x > 0.5) right += layer.ink.pen_mm * layer.ink.pen_mm;
        }
    EXPECT_NEAR(right / ink, 0.75, 0.03);
}

TEST(Stippling, OnATorusForATimeHasAsManyDotsAsOnABox) {
    StippleOptions options{.pens = Pens{0.5, 0.5}, .paper = Paper{80, 80}, .plot_seconds = 300};
    const Stippling box = stipple(ramp(), options);
    options.request.domain.boundary = Boundary::torus;
    const Stippling torus = stipple(ramp(), options);
    EXPECT_EQ(torus.result.points.size(), box.result.points.size());
    EXPECT_NEAR(torus.plot_seconds, 285, 15);
    EXPECT_NE(torus.result.points, box.result.points);
}

TEST(Stippling, AsLinesOfInksWithPensOfTheirOwnHasTheirWidthsAndTheirInk) {
    const Stippling made =
        stipple(kDrawing,
                {.inks = inks_of("red:0.5mm,blue:1mm"), .paper = Paper{80, 60}, .path_line = true});
    ASSERT_EQ(made.layers.size(), 2U);
    std::vector<double> lengths;
    std::size_t first = 0;
    for (const Layer& layer : made.layers) {
        double length = 0;
        for (std::size_t i = first + 1; i < first + layer.dots; ++i)
            length += std::hypot(made.result.points[i].x - made.result.points[i - 1].x,
                                 made.result.points[i].y - made.result.points[i - 1].y);
        lengths.push_back(80 * length);
        first += layer.dots;
    }
    const auto fields = separate(kDrawing, inks_of("red,blue"));
    for (std::size_t k = 0; k < 2; ++k)
        EXPECT_NEAR(lengths[k] * made.layers[k].ink.pen_mm / (4800 * mean_of(fields[k])), 1, 0.15)
            << k;
}

}  // namespace
}  // namespace lacuna
