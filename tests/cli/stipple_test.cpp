// Given a picture, `lacuna stipple` makes dots that look like it, in every format and order.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "cli/stippling.h"
#include "pictures/image.h"
#include "program.h"

namespace {

using namespace lacuna::test;
using lacuna::Point;

// The mean luminance in each of 32 x 24 blocks.
std::vector<double> blocks_of(const lacuna::pictures::Image& image) {
    constexpr std::size_t kAcross = 32, kDown = 24;
    std::vector<double> sums(kAcross * kDown), pixels(kAcross * kDown);
    for (std::size_t row = 0; row < image.rows; ++row)
        for (std::size_t column = 0; column < image.columns; ++column) {
            const std::size_t block =
                row * kDown / image.rows * kAcross + column * kAcross / image.columns;
            sums[block] += image.luminance[row * image.columns + column];
            ++pixels[block];
        }
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] /= pixels[i];
    return sums;
}

double mean_difference(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
    return sum / static_cast<double>(a.size());
}

TEST(Stipple, GivenACountThenThereAreExactlySoManyDotsInThePicturesShape) {
    const Folder folder;
    const std::vector<Point> points =
        points_of(grey_picture(folder, 6, 3, std::string(18, '\x40')), {"--count", "500"});
    ASSERT_EQ(points.size(), 500U);
    double right = 0, top = 0;
    for (const Point& point : points) {
        EXPECT_GE(std::min(point.x, point.y), 0);
        right = std::max(right, point.x);
        top = std::max(top, point.y);
    }
    EXPECT_LT(right, 1);
    EXPECT_GT(right, 0.95);
    EXPECT_LT(top, 0.5);
    EXPECT_GT(top, 0.45);
}

TEST(Stipple, GivenABlackCornerThenAllDotsLieThereAndItIsUpright) {
    const Folder folder;
    const std::string image = grey_picture(folder, 2, 2, bytes({0, 255, 255, 255}));
    for (const Point& point : points_of(image, {"--count", "300"})) {
        EXPECT_LT(point.x, 0.5);
        EXPECT_GE(point.y, 0.5);
    }
    std::size_t others = 0;
    const std::vector<Point> inverted = points_of(image, {"--count", "300", "--invert"});
    for (const Point& point : inverted) others += point.x >= 0.5 || point.y < 0.5 ? 1U : 0U;
    EXPECT_EQ(others, 300U);
    EXPECT_EQ(inverted.size(), 300U);
}

// Ratio of the dots in the dark left half to the dots in the lighter right half.
double left_to_right(const std::string& image, const Names& arguments) {
    double left = 0, right = 0;
    for (const Point& point : points_of(image, arguments)) ++(point.x < 0.5 ? left : right);
    return left / right;
}

TEST(Stipple, GivenTonesThenGammaAndTheLeastImportanceChangeTheirDensities) {
    const Folder folder;
    // Importance 0.8 and 0.4.
    const std::string image = grey_picture(folder, 2, 1, bytes({51, 153}));
    EXPECT_NEAR(left_to_right(image, {"--count", "8000"}), 2, 0.1);
    EXPECT_NEAR(left_to_right(image, {"--count", "8000", "--gamma", "2"}), 4, 0.3);
    EXPECT_NEAR(left_to_right(image, {"--count", "8000", "--invert"}), 1 / 3.0, 0.03);
    EXPECT_NEAR(left_to_right(image, {"--count", "8000", "--min-importance", "1"}), 1, 0.05);
}

TEST(Stipple, GivenAScaleThenTheSetIsMaximalAndItsLeastDistanceIsTheScale) {
    const Folder folder;
    const std::string image = grey_picture(folder, 1, 1, bytes({0}));
    const std::string report = folder.path("report.json");
    const Names arguments{"--scale", "0.03", "--torus", "--report", report};
    const std::vector<Point> points = points_of(image, arguments);
    double closest = 1;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const double dx = std::abs(points[i].x - points[j].x);
            const double dy = std::abs(points[i].y - points[j].y);
            closest = std::min(closest, std::hypot(std::min(dx, 1 - dx), std::min(dy, 1 - dy)));
        }
    EXPECT_GE(closest, 0.03);
    EXPECT_LT(closest, 0.0305);
    // docs/design.md, section 5, less the loss of a lattice of 10 steps to the radius.
    EXPECT_NEAR(static_cast<double>(points.size()), 0.66 / (0.03 * 0.03), 30);
    const auto json = nlohmann::json::parse(content_of(report));
    EXPECT_EQ(json.at("maximal"), true);
    EXPECT_EQ(json.at("scale"), 0.03);
    EXPECT_EQ(json.at("radius"), 0.03);
}

TEST(Stipple, GivenAMetricThenMaxLeavesAGapBesideTheDarkSideThatMinDoesNot) {
    const Folder folder;
    const std::string image = grey_picture(folder, 2, 1, bytes({0, 245}));  // radii 1 : 5
    const auto beside_the_edge = [&](const std::string& metric) {
        const std::vector<Point> points =
            points_of(image, {"--scale", "0.01", "--metric", metric, "--torus"});
        return std::count_if(points.begin(), points.end(),
                             [](const Point& point) { return point.x > 0.48 && point.x < 0.5; });
    };
    const std::ptrdiff_t min = beside_the_edge("min");
    const std::ptrdiff_t mean = beside_the_edge("mean");
    EXPECT_LT(mean, 0.9 * static_cast<double>(min));
    EXPECT_LT(beside_the_edge("max"), 0.9 * static_cast<double>(mean));
}

TEST(Stipple, GivenThePhotographThenThePictureOfTheDotsLooksLikeIt) {
    const Folder folder;
    const std::vector<double> photograph = blocks_of(lacuna::pictures::read_image(kRaccoon));
    // The errors that docs/stipple.md states; relaxed dots have slightly smaller ones.
    const std::vector<std::pair<Names, double>> ways{{{"--metric", "min"}, 0.035},
                                                     {{"--metric", "mean"}, 0.035},
                                                     {{"--metric", "max"}, 0.035},
                                                     {{"--relax", "15"}, 0.020}};
    for (const auto& [way, most] : ways) {
        const std::string path = folder.path(way.back() + ".png");
        const Names arguments = joined({"--count", "20000", "--dpi", "288"}, way);
        ASSERT_EQ(stipple(kRaccoon, arguments, path).exit_code, 0);
        const lacuna::pictures::Image picture = lacuna::pictures::read_image(path);
        EXPECT_EQ(picture.columns, 2048U);
        EXPECT_EQ(picture.rows, 1536U);
        EXPECT_LT(mean_difference(blocks_of(picture), photograph), most) << way.back();
    }
}

TEST(Stipple, GivenAFixedDotSizeThenThePictureHasSoMuchInk) {
    const Folder folder;
    const std::string image = grey_picture(folder, 1, 1, bytes({128}));
    const std::string path = folder.path("a.png");
    const Names arguments{"--count",   "200",      "--dot-size", "1mm",   "--paper-size",
                          "120x100mm", "--margin", "10mm",       "--dpi", "254"};
    ASSERT_EQ(stipple(image, arguments, path).exit_code, 0);
    const lacuna::pictures::Image picture = lacuna::pictures::read_image(path);
    ASSERT_EQ(picture.columns, 1200U);
    ASSERT_EQ(picture.rows, 1000U);
    double ink = 0;
    for (std::size_t row = 0; row < picture.rows; ++row)
        for (std::size_t column = 0; column < picture.columns; ++column) {
            const double dark = 1 - picture.luminance[row * picture.columns + column];
            ink += dark;
            // Dots may stick out of the domain, 80 mm x 80 mm in the middle, by half of their size.
            if (dark == 0) continue;
            ASSERT_TRUE(column >= 194 && column < 1006 && row >= 94 && row < 906);
        }
    EXPECT_NEAR(ink, 200 * 3.14159 * 5 * 5, 200);
}

TEST(Stipple, WarnsInOneLineOfDotsWithLessThanHalfOfTheInkOrMoreThanTwice) {
    const Folder folder;
    const std::string grey = grey_picture(folder, 1, 1, bytes({128}));  // importance 127 / 255
    const auto warning = [&](const Names& more) {
        Names words{"stipple", grey, "--paper-size", "120x100mm",         "--margin", "10mm",
                    "--relax", "0",  "-o",           folder.path("a.svg")};
        words.insert(words.end(), more.begin(), more.end());
        const std::string err = run(words).err;
        return err.starts_with("lacuna: ") ? err.substr(0, err.find('\n')) : "";
    };
    // 80 mm x 80 mm, half of it black, is 4058 dots of 1 mm.
    EXPECT_EQ(warning({"--count", "100", "--dot-size", "1mm"}),
              "lacuna: 100 dots of 1mm have 2.5 % of the picture's ink: about 4060 dots, or "
              "--dot-size 6.4mm, would suit");
    EXPECT_EQ(warning({"--count", "1000", "--dot-size", "4mm"}),
              "lacuna: 1000 dots of 4mm have 394 % of the picture's ink: about 254 dots, or "
              "--dot-size 2mm, would suit");
    EXPECT_EQ(warning({"--count", "2100", "--dot-size", "1mm"}), "");
    EXPECT_EQ(warning({"--count", "8000", "--dot-size", "1mm"}), "");
    EXPECT_EQ(warning({"--dot-size", "1mm"}), "");
    EXPECT_EQ(warning({"--count", "100"}), "");
    EXPECT_EQ(warning({"--count", "100", "--dot-size", "1mm", "--quiet"}), "");
    const Outcome sampled = run({"sample", "--field", grey, "--count", "50", "--dot-size", "0.1mm",
                                 "-o", folder.path("b.svg")});
    EXPECT_TRUE(sampled.err.starts_with("lacuna: 50 dots of 0.1mm have ")) << sampled.err;
}

TEST(Stipple, EndsWithOneLineAndReportsWhatItMade) {
    const Folder folder;
    const std::string path = folder.path("a.svg"), report = folder.path("a.json");
    const Outcome outcome = run({"stipple", kRaccoon, "--count", "1000", "--seed", "3", "--metric",
                                 "mean", "--lines-per-radius", "5", "--relax", "0", "--backend",
                                 "reference", "-o", path, "--report", report});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_TRUE(outcome.err.starts_with("1000 dots, scale 0.0")) << outcome.err;
    EXPECT_TRUE(outcome.err.ends_with("-> " + path + "\n")) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);

    const auto json = nlohmann::json::parse(content_of(report));
    const auto expected = nlohmann::json::parse(R"({
        "width": 1.0, "height": 0.75, "boundary": "box", "mode": "cells", "metric": "mean",
        "scale": null, "count": 1000, "lines_per_radius": 5, "limit": null, "round_size": 0,
        "seed": 3, "backend": "reference", "device": "", "threads": 0, "invert": false,
        "gamma": 1.0, "black": 0.0, "white": 1.0,
        "auto_levels": false, "min_importance": 0.0, "relax": 0, "pen_path": false, "dot_size_mm": "radius",
        "paper_mm": null, "margin_mm": 0.0, "dpi": 144.0})");
    auto request = json.at("request");
    EXPECT_EQ(request.at("image"), kRaccoon);
    request.erase("image");
    EXPECT_EQ(request, expected);
    EXPECT_EQ(json.at("count"), 1000);
    EXPECT_EQ(json.at("image").at("columns"), 1024);
    EXPECT_EQ(json.at("image").at("rows"), 768);
    EXPECT_GT(json.at("scale"), 0.01);
    EXPECT_LT(json.at("scale"), 0.03);
    EXPECT_GE(json.at("radius"), json.at("scale"));
    EXPECT_EQ(json.at("points_sha256").get<std::string>().size(), 64U);
}

TEST(Stipple, WithoutACountMakesAsManyDotsAsSuitThePictureAndSaysSo) {
    const Folder folder;
    // Half black, 100 x 50 pixels that count as 512 x 256: one dot for 16 of 65,536.
    const std::string image =
        grey_picture(folder, 100, 50, std::string(2500, '\0') + std::string(2500, '\xff'));
    const Outcome outcome = run({"stipple", image, "-o", folder.path("a.svg")});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_TRUE(outcome.err.starts_with(
        "4096 dots (chosen for the picture: --count gives another number), "))
        << outcome.err;
    // 80 mm x 40 mm, half of it covered by dots of pi / 4 square mm.
    const Outcome sized = run({"stipple", image, "--paper-size", "80x40mm", "--dot-size", "1mm",
                               "-o", folder.path("a.svg")});
    EXPECT_TRUE(sized.err.starts_with("2037 dots (")) << sized.err;
}

TEST(Stipple, OfOneDotSaysSo) {
    const Folder folder;
    const Outcome outcome = run({"stipple", kRaccoon, "--count", "1", "-o", folder.path("a.svg")});
    EXPECT_TRUE(outcome.err.starts_with("1 dot, ")) << outcome.err;
}

// A black disk in the middle.
std::string disk(const Folder& folder) {
    constexpr int kSide = 60;
    std::string pixels;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            pixels += std::hypot(x - 29.5, y - 29.5) < 20 ? '\0' : '\xff';
    return grey_picture(folder, kSide, kSide, pixels);
}

TEST(Stipple, KeepsDotsInsideOfShapesWhereItIsToldTo) {
    const Folder folder;
    const std::string image = disk(folder);
    const auto farthest = [&](Names arguments) {
        arguments.insert(arguments.begin(), {"--count", "200", "--relax", "15"});
        arguments.insert(arguments.end(), {"--paper-size", "60x60mm"});
        const Outcome outcome = stipple(image, arguments, folder.path("a.json"));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        const auto set = nlohmann::json::parse(content_of(folder.path("a.json")));
        double reach = 0;
        for (std::size_t i = 0; i < 200; ++i) {
            const double x = set.at("points")[i][0], y = set.at("points")[i][1];
            reach = std::max(
                reach, std::hypot(x - 0.5, y - 0.5) + set.at("dots").at("radii")[i].get<double>());
        }
        return reach * 60;
    };
    // Pixels reach at most 20.7 pixels from the middle.
    EXPECT_LE(farthest({"--keep-inside"}), 20.8);
    EXPECT_LE(farthest({"--keep-inside", "--size-by-tone", "1"}), 20.8);
    EXPECT_LE(farthest({"--keep-inside", "--inks", "black"}), 20.8);
    EXPECT_LE(farthest({"--keep-inside", "--pen-path"}), 20.8);
    EXPECT_GT(farthest({"--dot-size", "4mm"}), 21);
    // A pen keeps its size, and is only moved.
    EXPECT_LE(farthest({"--keep-inside", "--dot-size", "4mm"}), 20.8);
}

TEST(Stipple, MakesEveryKindOfFileTwiceTheSame) {
    const Folder folder;
    for (const std::string extension :
         {".txt", ".csv", ".npy", ".ply", ".json", ".svg", ".pdf", ".png"}) {
        const std::string one = folder.path("one" + extension),
                          two = folder.path("two" + extension);
        for (const std::string& path : {one, two})
            ASSERT_EQ(stipple(kRaccoon, {"--count", "200"}, path).exit_code, 0) << extension;
        EXPECT_GT(content_of(one).size(), 1000U) << extension;
        EXPECT_EQ(content_of(one), content_of(two)) << extension;
    }
}

}  // namespace
