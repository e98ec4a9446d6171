// lacuna::stipple: its defaults, its rules, and its dots.
#include <gtest/gtest.h>
#include <lacuna/stipple.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "judge/plane.h"
#include "recipes/stippled_pictures.h"
#include "refusal.h"

namespace lacuna {
namespace {

using namespace tests::stippled;
using tests::refusal_of;

TEST(Stippling, HasTheNumberOfDotsAskedForAndASizeForEach) {
    const Stippling made = stipple(kDrawing, counted(300));
    EXPECT_EQ(made.result.points.size(), 300U);
    EXPECT_EQ(made.diameters.size(), 300U);
    EXPECT_EQ(made.request.mode, Mode::stratified);
    EXPECT_EQ(made.iterations, 15U);
    EXPECT_EQ(made.request.domain.height, 0.75);
    EXPECT_EQ(made.request.field, nullptr);
    EXPECT_EQ(made.columns, 4U);
    EXPECT_EQ(made.result.radius,
              judge::closest_pair(made.request.domain, made.result.points).distance);
    EXPECT_FALSE(made.result.maximal);
}

TEST(Stippling, ThatIsNotRelaxedIsTheSetOfSample) {
    const Field field = importance_of(kDrawing, {});
    StippleOptions options;
    options.request.scale = 0.05;
    options.relax = 0;
    for (const Mode mode : {Mode::cells, Mode::exact}) {
        options.start = mode;
        const Stippling made = stipple(kDrawing, options);
        Request request = made.request;
        request.field = &field;
        EXPECT_EQ(made.result.points, sample(request).points);
        EXPECT_TRUE(made.result.maximal);
    }
}

TEST(Stippling, ChoosesANumberThatSuitsThePictureOrThePens) {
    // Black counts as 512 x 512 pixels, 16 of them a dot.
    EXPECT_EQ(stipple(kBlack, {.relax = 1}).result.points.size(), 16384U);
    const Stippling drawn =
        stipple(kBlack, {.relax = 1, .pens = Pens{2, 2}, .paper = Paper{100, 120, 9}});
    // Within the margins and half of the pen 80 mm x 80 mm over pi mm^2, and 1.12^2 times as many
    // because dots overlap.
    EXPECT_EQ(drawn.result.points.size(), 2555U);
    EXPECT_NEAR(drawn.dots_for_ink, 1.12 * 1.12 * 6400 / 3.14159265, 1e-3);
    EXPECT_EQ(drawn.diameters.front(), 2.0 / 80);
}

TEST(Stippling, TurnsPaperThatMayTurn) {
    StippleOptions options = counted(20);
    options.paper = Paper{210, 297, 20, true};
    EXPECT_EQ(stipple(kDrawing, options).paper->width_mm, 297);
    options.paper->may_turn = false;
    EXPECT_EQ(stipple(kDrawing, options).paper->width_mm, 210);
}

TEST(Stippling, InInksGivesEachInkItsDots) {
    StippleOptions options = in_inks("red,blue", 90);
    const Stippling shared = stipple(kDrawing, options);
    EXPECT_EQ(shared.layers[0].dots + shared.layers[1].dots, 90U);
    options.request.count.reset();
    options.ink_counts = {70, 100};
    EXPECT_EQ(dots_of(stipple(kDrawing, options)), (std::vector<std::size_t>{70, 100}));
    options.ink_counts = {0, 9};
    EXPECT_EQ(dots_of(stipple(kDrawing, options)), (std::vector<std::size_t>{0, 9}));
}

TEST(Stippling, OfABlackPictureIsBlack) {
    StippleOptions options = in_inks("cmyk", 100);
    EXPECT_EQ(dots_of(stipple(kBlack, options)), (std::vector<std::size_t>{0, 0, 0, 100}));
    options.request.count.reset();
    options.ink_counts = {0, 0, 0, 100};
    EXPECT_EQ(dots_of(stipple(kBlack, options)), options.ink_counts);
}

TEST(Stippling, IsTheSameOnEveryBackendAndNumberOfThreads) {
    StippleOptions options = in_inks("red,black,blue", 200);
    options.relax = 3;
    const std::vector<Point> points = stipple(kDrawing, options).result.points;
    options.request.place.threads = 1;
    EXPECT_EQ(stipple(kDrawing, options).result.points, points);
    options.request.place.backend = "reference";
    EXPECT_EQ(stipple(kDrawing, options).result.points, points);
}

TEST(Stippling, KeptInsideDrawsThinLinesWithSmallerDots) {
    // A black block of 60 x 60 pixels, and a line of 3 pixels beside it.
    std::string pixels = "P2 120 60 255";
    for (int row = 0; row < 60; ++row)
        for (int column = 0; column < 120; ++column)
            pixels += column < 60 || (column >= 90 && column < 93) ? " 0" : " 255";
    const Picture drawing{pixels, "a block and a line"};
    constexpr double kPixel = 1.0 / 120;
    for (const bool in_ink : {false, true}) {
        StippleOptions options = in_ink ? in_inks("black", 150) : counted(150);
        options.keep_inside = true;
        const Stippling made = stipple(drawing, options);
        ASSERT_EQ(made.diameters.size(), 150U);
        double in_block = 0, on_line = 0, widest_on_line = 0, widest = 0;
        for (std::size_t i = 0; i < made.diameters.size(); ++i) {
            const double diameter = made.diameters[i];
            const bool is_on_line = made.result.points[i].x > 75 * kPixel;
            (is_on_line ? on_line : in_block) += 3.14159265 / 4 * diameter * diameter;
            double& most = is_on_line ? widest_on_line : widest;
            most = std::max(most, diameter);
        }
        EXPECT_LE(widest_on_line, 3.001 * kPixel);
        EXPECT_GT(widest, 2 * widest_on_line);
        EXPECT_GT(on_line, 0.5 * 3 * kPixel * 0.5) << "of the line's area";
        EXPECT_GT(in_block, 0.9 * 0.25);
    }
}

TEST(Stippling, OnDarkPaperDrawsWhatIsLight) {
    StippleOptions options = in_inks("white", 400);
    options.paper_colour = {0, 0, 0};
    const Stippling made = stipple(ramp(), options);
    EXPECT_EQ(made.paper_colour, options.paper_colour);
    // A grey shows its number, or with light its light, which is that of sRGB.
    for (const bool light : {false, true}) {
        const std::vector<Field> fields =
            separate(ramp(), inks_of("white"), {.light = light}, kBlackInk, options.paper_colour);
        EXPECT_EQ(fields[0].importance[0], 0);
        const double number = 32. / 63;
        EXPECT_NEAR(fields[0].importance[32],
                    light ? std::pow((number + 0.055) / 1.055, 2.4) : number, 1e-3);
        EXPECT_NEAR(fields[0].importance[63], 1, 1e-9);
    }
    // Paper that is hardly not white gives the same inks by the other formula.
    const auto near = separate(kDrawing, inks_of("red,blue"), {}, 0, {255, 255, 254});
    const auto white = separate(kDrawing, inks_of("red,blue"), {}, 0);
    for (std::size_t k = 0; k < 2; ++k)
        for (std::size_t i = 0; i < 12; ++i)
            EXPECT_NEAR(near[k].importance[i], white[k].importance[i], 0.02) << k << " " << i;
}

// Pixels of a disk of 20 pixels reach at most 20.7 pixels from the middle of 60 x 60.
TEST(Stippling, KeepsDotsInsideOfShapesWhateverTheirSizesInksAndOrder) {
    std::string pixels = "P2 60 60 1";
    for (int i = 0; i < 3600; ++i)
        pixels += std::hypot(i % 60 - 29.5, i / 60 - 29.5) < 20 ? " 0" : " 1";
    const Picture disk{pixels, "disk"};
    const auto farthest = [&](StippleOptions options) {
        options.request.count = 200;
        options.paper = Paper{60, 60};
        const Stippling made = stipple(disk, options);
        double reach = 0;
        for (std::size_t i = 0; i < 200; ++i) {
            const Point& dot = made.result.points[i];
            reach = std::max(reach, std::hypot(dot.x - 0.5, dot.y - 0.5) + made.diameters[i] / 2);
        }
        return 60 * reach;
    };
    EXPECT_GT(farthest({.pens = Pens{4, 4}}), 21);
    EXPECT_LE(farthest({.pens = Pens{4, 4}, .keep_inside = true}), 20.8);
    EXPECT_LE(farthest({.size_by_tone = 1, .keep_inside = true}), 20.8);
    EXPECT_LE(farthest({.inks = inks_of("black"), .keep_inside = true}), 20.8);
    EXPECT_LE(farthest({.keep_inside = true, .pen_path = true}), 20.8);
}

TEST(Stippling, ReportsItsStagesAndCanBeCancelledInEach) {
    struct Watch : Observer {
        std::vector<Stage> stages{};
        Stage cancels = Stage::sampling;
        bool is_cancelling = false;
        bool keep_going(const Progress& progress) override {
            if (stages.empty() || stages.back() != progress.stage) stages.push_back(progress.stage);
            return !(is_cancelling && progress.stage == cancels);
        }
    };
    StippleOptions options = counted(300);
    options.pen_path = true;
    Watch watch;
    stipple(kDrawing, options, watch);
    EXPECT_EQ(watch.stages, (std::vector{Stage::sampling, Stage::relaxing, Stage::pen_path}));
    watch.is_cancelling = true;
    for (const Stage stage : {Stage::sampling, Stage::relaxing, Stage::pen_path}) {
        watch.cancels = stage;
        EXPECT_THROW(stipple(kDrawing, options, watch), Cancelled);
    }
}

TEST(Stippling, RefusesWhatCannotBe) {
    struct Case {
        const char* message;
        StippleOptions options;
    };
    const std::vector<Ink> red = inks_of("red");
    const Paper postcard{148, 105, 60};
    const std::vector<Case> cases{
        {"black-ink 1 without --inks: is for", {.black_ink = 1}},
        {"black-ink 2: must be", {.inks = red, .black_ink = 2}},
        {"ink-counts 2 numbers: must be one for each ink, 1", {.inks = red, .ink_counts = {1, 2}}},
        {"ink-counts 0: must not be 0 for all inks", {.inks = red, .ink_counts = {0}}},
        {"ink-counts 9 with --count: both give",
         {.request = {.count = 9}, .inks = red, .ink_counts = {9}}},
        {"mode cells with --inks: dots of", {.start = Mode::cells, .inks = red}},
        {"metric min with --inks: dots of", {.metric = Metric::min, .inks = red}},
        {"limit 5 with --inks: dots of", {.request = {.limit = 5}, .inks = red}},
        {"lines-per-radius 5 with --inks: dots of",
         {.request = {.paper2011 = {.lines_per_radius = 5}}, .inks = red}},
        {"round-size 5 with --inks: dots of",
         {.request = {.paper2011 = {.round_size = 5}}, .inks = red}},
        {"relax 10001: must be at most 10000", {.relax = 10001}},
        {"relax 0: must be at least 1 for inks", {.relax = 0, .inks = red}},
        {"along 3 with --inks: dots of", {.tone = {.along = 3}, .inks = red}},
        {"along 3 with --relax: relaxing has disks", {.relax = 2, .tone = {.along = 3}}},
        {"along 3 with --mode=cells: is for --mode exact",
         {.start = Mode::cells, .tone = {.along = 3}}},
        {"mode lines: must be stratified, cells or exact", {.start = Mode::lines}},
        {"mode stratified: is a start for --relax", {.start = Mode::stratified, .relax = 0}},
        {"size-by-tone 2: must be 0 to 1", {.size_by_tone = 2}},
        {"size-by-tone 1: is not for a --dot-size", {.size_by_tone = 1, .pens = Pens{1, 1}}},
        {"inks white: is the colour of the paper, #ffffff, ", {.inks = inks_of("red,white")}},
        {"black-ink 1: is for white paper, not for #000000",
         {.inks = red, .black_ink = 1, .paper_colour = {0, 0, 0}}},
        {"paper-colour #202020: is too dark for black dots", {.paper_colour = {32, 32, 32}}},
        {"dot-size 0.3mm..0.5mm: must be one pen with --along",
         {.tone = {.along = 3}, .pens = Pens{0.3, 0.5}}},
        {"path-line with 0.3mm..0.5mm: must have one pen",
         {.pens = Pens{0.3, 0.5}, .path_line = true}},
        {"keep-inside with --along: is for dots",
         {.tone = {.along = 3}, .pens = Pens{0.3, 0.3}, .keep_inside = true}},
        {"inks red: needs a pen, as others have: give it one, such as red:0.5mm",
         {.inks = inks_of("black:0.3mm,red")}},
        {"size-by-tone 1: is not for pens", {.inks = inks_of("red:0.3mm"), .size_by_tone = 1}},
        {"pens 300 widths: must be at most 254 layers",
         {.pens = Pens{1, 300,
                       [] {
                           std::vector<double> widths(300);
                           for (int i = 0; i < 300; ++i) widths[std::size_t(i)] = i + 1;
                           return widths;
                       }()}}},
        {"path-line with --keep-inside: a line has no dots",
         {.keep_inside = true, .path_line = true}},
        {"pens 0.4mm: must be widths", {.pens = Pens{0.5, 0.6, {0.5, 0.4, 0.6}}}},
        {"plot-time 60s with --count: both give", {.request = {.count = 9}, .plot_seconds = 60}},
        {"plot-time 60: needs a plotter", {.plotter = {0, 0, 0}, .plot_seconds = 60}},
        {"seconds-per-dot -1: must be a finite", {.pen_path = true, .plotter = {-1, 0}}},
        {"seconds-per-corner -1: must be a finite",
         {.pen_path = true, .plotter = {.seconds_per_corner = -1}}},
        {"margin 50mm: leaves no room on the paper for a pen of 6mm",
         {.pens = Pens{6, 6}, .paper = Paper{148, 105, 50}}},
        {"margin 60mm: must be less than half of the paper's 105mm", {.paper = postcard}},
        {"gamma 0: must be", {.tone = {.gamma = 0}}},
        {"ink-counts 5: must be 0 for blue: the picture needs none",
         {.inks = inks_of("black,blue"), .ink_counts = {5, 5}}}};
    for (const Case& one : cases)
        EXPECT_EQ(refusal_of([&] {
                      stipple(kBlack, one.options);
                  }).substr(0, std::string(one.message).size()),
                  one.message);
    EXPECT_THROW(stipple(Picture{"P2 1 1 1 1", "white"}), FileError);
    EXPECT_THROW(stipple(Picture{"no picture", "text"}), FileError);
}

}  // namespace
}  // namespace lacuna
