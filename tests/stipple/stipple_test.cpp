// lacuna::stipple: its defaults, its rules, and its dots.
#include <gtest/gtest.h>
#include <lacuna/stipple.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

#include "judge/plane.h"
#include "refusal.h"
#include "stipple/stippled_pictures.h"

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

// What only a program in C++ can ask for; all else is in tests/refusals.txt.
TEST(Stippling, RefusesPensThatCannotBe) {
    const auto refused = [](const StippleOptions& options) {
        return refusal_of([&] { stipple(kBlack, options); });
    };
    Pens many{1, 300, std::vector<double>(300)};
    std::iota(many.widths_mm.begin(), many.widths_mm.end(), 1);
    EXPECT_EQ(refused({.pens = many}),
              "pens 300 widths: must be at most 254 layers of inks and pens");
    EXPECT_EQ(refused({.pens = Pens{0.5, 0.6, {0.5, 0.4, 0.6}}}),
              "pens 0.4mm: must be widths over 0, in ascending order");
    EXPECT_THROW(stipple(Picture{"no picture", "text"}), FileError);
}

}  // namespace
}  // namespace lacuna
