// A picture that `lacuna stipple` draws, made smaller, is the photograph made smaller, in every way
// of drawing: areas average as numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "cli/stippling.h"
#include "pictures/image.h"

namespace {

using namespace lacuna::tests;
using lacuna::pictures::Colours;
using lacuna::pictures::Image;

constexpr std::size_t kBlock = 32;  // pixels of the photograph, in both directions

// The mean number in each block of a photograph, or of a picture `times` as large, but for blocks
// at an edge of `paper`: all ink lies on it, so a strip of half a dot's width is white.
std::vector<double> blocks_of(const Image& image, std::size_t times, bool paper) {
    const std::size_t side = times * kBlock;
    const std::size_t across = image.columns / side, down = image.rows / side;
    std::vector<double> means(across * down);
    for (std::size_t row = 0; row < down * side; ++row)
        for (std::size_t column = 0; column < across * side; ++column)
            means[row / side * across + column / side] +=
                image.luminance[row * image.columns + column] / static_cast<double>(side * side);
    if (!paper) return means;
    std::vector<double> inner;
    for (std::size_t row = 1; row + 1 < down; ++row)
        for (std::size_t column = 1; column + 1 < across; ++column)
            inner.push_back(means[row * across + column]);
    return inner;
}

double mean_difference(const std::vector<double>& a, const std::vector<double>& b) {
    EXPECT_EQ(a.size(), b.size());
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
    return sum / static_cast<double>(a.size());
}

struct Photograph {
    std::string path;
    std::size_t times;    // pixels of the drawing for one of the photograph
    std::string paper;    // of its shape, 200 mm wide or high
    std::string pen;      // about 20,000 dots of it have the picture's ink
    std::string strokes;  // or 20,000 strokes
};

// Ten steps of grey, each two blocks wide.
std::string ten_steps(const Folder& folder) {
    constexpr int kColumns = 640, kRows = 320;
    std::string pixels;
    for (int i = 0; i < kColumns * kRows; ++i)
        pixels += static_cast<char>(i % kColumns / (kColumns / 10) * 255 / 9);
    return grey_picture(folder, kColumns, kRows, pixels);
}

std::vector<Photograph> photographs(const Folder& folder) {
    return {{LACUNA_EXAMPLES "/hopper.jpg", 3, "170.6667x200mm", "1.28mm", "0.86mm"},
            {LACUNA_EXAMPLES "/raccoon.png", 2, "200x150mm", "1.04mm", "0.8mm"},
            {ten_steps(folder), 3, "200x100mm", "0.8mm", "0.6mm"}};
}

struct Way {
    const char* name;
    Names options;
    double most;              // mean difference of blocks
    bool is_in_ink = false;   // its colours are compared
    bool is_on_paper = true;  // of Photograph
};

std::vector<Way> ways(const Photograph& photograph) {
    const Names count{"--count", "20000"};
    return {{"dots", count, 0.02, false, false},
            {"dots of many sizes", joined(count, {"--size-by-tone", "0.5"}), 0.02, false, false},
            {"not relaxed", joined(count, {"--relax", "0"}), 0.035, false, false},
            {"long dots", joined(count, {"--along", "4"}), 0.035, false, false},
            {"one line", joined(count, {"--path-line"}), 0.02, false, false},
            {"black ink", joined(count, {"--inks", "black"}), 0.02, false, false},
            {"one pen", {"--dot-size", photograph.pen}, 0.02},
            {"three pens", {"--pens", "0.5mm,0.8mm,1.2mm"}, 0.02},
            {"a pen's line", {"--path-line", "--dot-size", "0.5mm"}, 0.02},
            {"strokes", joined(count, {"--along", "6", "--dot-size", photograph.strokes}), 0.02},
            {"four inks", joined(count, {"--inks", "cmyk"}), 0.05, true, false}};
}

// As many pixels an inch as give `times` those of the photograph.
std::string resolution(const Photograph& photograph, const Way& way) {
    const Image image = lacuna::pictures::read_image(photograph.path);
    constexpr double kMillimetres = 200, kMillimetresOfInch = 25.4;
    constexpr double kPoints = 512, kPointsOfInch = 72;  // of a page without paper
    const double inches =
        way.is_on_paper ? kMillimetres / kMillimetresOfInch : kPoints / kPointsOfInch;
    return std::to_string(
        static_cast<double>(photograph.times * std::max(image.columns, image.rows)) / inches);
}

class ADrawing : public testing::TestWithParam<std::size_t> {};

TEST_P(ADrawing, MadeSmallerIsThePhotographMadeSmallerInEveryWay) {
    const Folder folder;
    const Photograph photograph = photographs(folder).at(GetParam());
    const std::string bytes = content_of(photograph.path), path = folder.path("drawn.png");
    const Colours colours = lacuna::pictures::decode_colours(bytes, photograph.path);
    const Image grey = lacuna::pictures::read_image(photograph.path);
    for (const Way& way : ways(photograph)) {
        Names words{
            "stipple", photograph.path, "--dpi", resolution(photograph, way), "--quiet", "-o",
            path};
        if (way.is_on_paper) words = joined(words, {"--paper-size", photograph.paper});
        const Outcome outcome = run(joined(words, way.options));
        ASSERT_EQ(outcome.exit_code, 0) << way.name << outcome.err;
        const auto expect_near = [&](const Image& its, const Image& wanted) {
            ASSERT_EQ(its.columns, photograph.times * wanted.columns) << way.name;
            EXPECT_LE(mean_difference(blocks_of(its, photograph.times, way.is_on_paper),
                                      blocks_of(wanted, 1, way.is_on_paper)),
                      way.most)
                << way.name;
        };
        if (!way.is_in_ink) {
            expect_near(lacuna::pictures::read_image(path), grey);
            continue;
        }
        const Colours drawn = lacuna::pictures::decode_colours(content_of(path), path);
        expect_near(drawn.red, colours.red);
        expect_near(drawn.green, colours.green);
        expect_near(drawn.blue, colours.blue);
    }
}

INSTANTIATE_TEST_SUITE_P(OfHopperTheRaccoonAndTenSteps, ADrawing, testing::Values(0, 1, 2));

// For prints seen from afar: 188 of 255 reflects half of the light, and 128 a bit over a fifth.
TEST(Light, AveragesByAreaInEveryWayIfItIsAskedFor) {
    const Folder folder;
    const std::string path = folder.path("drawn.png");
    const std::string greys =
        grey_picture(folder, 2, 1, std::string{static_cast<char>(188), static_cast<char>(128)});
    for (const Names& way : {Names{}, Names{"--inks", "black"}, Names{"--path-line"},
                             Names{"--inks", "white", "--paper-colour", "black"}}) {
        ASSERT_EQ(
            run(joined({"stipple", greys, "--light", "--count", "8000", "--quiet", "-o", path},
                       way))
                .exit_code,
            0);
        const Image drawn = lacuna::pictures::read_image(path);
        const std::vector<double> expected{0.503, 0.216};
        std::vector<double> halves(2);
        for (std::size_t i = 0; i < drawn.luminance.size(); ++i)
            halves[i % drawn.columns * 2 / drawn.columns] +=
                2 * drawn.luminance[i] / static_cast<double>(drawn.luminance.size());
        for (std::size_t half = 0; half < 2; ++half)
            EXPECT_NEAR(halves[half], expected[half], 0.02) << half;
    }
}

}  // namespace
