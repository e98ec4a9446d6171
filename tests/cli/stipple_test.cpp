// Given a picture, `lacuna stipple` makes dots that look like it, in every format and order.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "cli/stippling.h"
#include "pictures/image.h"
#include "pictures/importance.h"
#include "program.h"

namespace {

using namespace lacuna::tests;
using lacuna::Point;

// The light of a photograph's numbers. The numbers of a picture of dots are shares of white paper.
lacuna::pictures::Image light_of(lacuna::pictures::Image photograph) {
    for (double& one : photograph.luminance) one = lacuna::pictures::light_of(one);
    return photograph;
}

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

double mean_of(const lacuna::pictures::Image& image) {
    return std::reduce(image.luminance.begin(), image.luminance.end()) /
           static_cast<double>(image.luminance.size());
}

double mean_difference(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
    return sum / static_cast<double>(a.size());
}

TEST(Stipple, GivenThePhotographThenThePictureOfTheDotsLooksLikeIt) {
    const Folder folder;
    const std::vector<double> photograph =
        blocks_of(light_of(lacuna::pictures::read_image(kRaccoon)));
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

// Each step's mean number in the picture of the dots is the share of white paper.
TEST(Stipple, GivenTenStepsOfGreyThenEachHasItsLightInEveryWay) {
    const Folder folder;
    std::string pixels;
    for (int step = 0; step < 10; ++step) pixels += static_cast<char>(step * 255 / 9);
    const std::string steps = grey_picture(folder, 10, 1, pixels);
    // Half of the widest pen, 0.8 mm, is free around the picture.
    const Names paper{"--paper-size", "250.8x25.8mm"};
    for (const Names& way :
         {Names{"--count", "20000"}, Names{"--count", "20000", "--size-by-tone", "0.5"},
          Names{"--count", "20000", "--inks", "black"}, joined({"--dot-size", "0.4mm"}, paper),
          joined({"--pens", "0.3mm,0.5mm,0.8mm"}, paper), joined({"--inks", "black:0.4mm"}, paper),
          joined({"--path-line", "--dot-size", "0.3mm"}, paper),
          joined({"--along", "4", "--dot-size", "0.3mm"}, paper)}) {
        const std::string path = folder.path("dots.png");
        ASSERT_EQ(run(joined({"stipple", steps, "--dpi", "300", "-o", path}, way)).exit_code, 0);
        const lacuna::pictures::Image dots = lacuna::pictures::read_image(path);
        const double white = *std::max_element(dots.luminance.begin(), dots.luminance.end());
        for (std::size_t step = 0; step < 10; ++step) {
            double sum = 0, count = 0;
            for (std::size_t row = dots.rows / 8; row < dots.rows * 7 / 8; ++row)
                for (std::size_t column = (10 * step + 1) * dots.columns / 100;
                     column < (10 * step + 9) * dots.columns / 100; ++column, ++count)
                    sum += dots.luminance[row * dots.columns + column];
            const double light = lacuna::pictures::light_of(static_cast<double>(step) / 9);
            EXPECT_NEAR(sum / count / white, light, 0.02) << step << " " << way.back();
        }
    }
}

TEST(Stipple, GivenAPhotographThenDotsThatAreNotRelaxedHaveItsLight) {
    const Folder folder;
    const std::string photograph = LACUNA_EXAMPLES "/hopper.jpg", path = folder.path("drawn.png");
    const double light = mean_of(light_of(lacuna::pictures::read_image(photograph)));
    for (const Names& way : {Names{"--relax", "0"}, Names{"--relax", "0", "--mode", "exact"},
                             Names{"--relax", "0", "--metric", "mean"}, Names{"--along", "4"}}) {
        const Names sheet{"stipple", photograph, "--dpi", "300", "--quiet", "-o", path};
        ASSERT_EQ(run(joined(sheet, way)).exit_code, 0);
        EXPECT_NEAR(mean_of(lacuna::pictures::read_image(path)), light, 3.0 / 255) << way.back();
    }
}

// A line and strokes lie on themselves where it is dark.
TEST(Stipple, GivenAPhotographThenALineAndStrokesHaveItsLight) {
    const Folder folder;
    const std::string photograph = LACUNA_EXAMPLES "/hopper.jpg", path = folder.path("drawn.png");
    const double light = mean_of(light_of(lacuna::pictures::read_image(photograph)));
    for (const Names& way : {Names{"--path-line"}, Names{"--along", "6"}}) {
        const Names sheet{"stipple",
                          photograph,
                          "--dot-size",
                          "0.4mm",
                          "--paper-size",
                          "200x234.375mm",
                          "--margin",
                          "0mm",
                          "--quiet",
                          "-o",
                          path};
        ASSERT_EQ(run(joined(sheet, way)).exit_code, 0);
        EXPECT_NEAR(mean_of(lacuna::pictures::read_image(path)), light, 3.0 / 255) << way.front();
    }
}

TEST(Stipple, WarnsInOneLineOfDotsWithLessThanHalfOfTheInkOrMoreThanTwice) {
    const Folder folder;
    const std::string grey = grey_picture(folder, 1, 1, bytes({188}));  // half of the light
    const auto warning = [&](const Names& more) {
        Names words{"stipple", grey, "--paper-size", "121x101mm",         "--margin", "10mm",
                    "--relax", "0",  "-o",           folder.path("a.svg")};
        words.insert(words.end(), more.begin(), more.end());
        const std::string err = run(words).err;
        return err.starts_with("lacuna: ") ? err.substr(0, err.find('\n')) : "";
    };
    // Within the margins and half of a pen of 1 mm 80 mm x 80 mm, half of it black, is 4051 dots.
    EXPECT_EQ(warning({"--count", "100", "--dot-size", "1mm"}),
              "lacuna: 100 dots of 1mm have 2.5 % of the picture's ink: about 4050 dots, or "
              "--dot-size 6.4mm, would suit");
    EXPECT_EQ(warning({"--count", "1000", "--dot-size", "4mm"}),
              "lacuna: 1000 dots of 4mm have 426 % of the picture's ink: about 235 dots, or "
              "--dot-size 1.9mm, would suit");
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
        "light": true, "gamma": 1.0, "black": 0.0, "white": 1.0,
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
    // 80 mm x 40 mm, half of it covered by dots of pi / 4 square mm: 1.12^2 times as many as their
    // areas alone ask for, because they overlap.
    const Outcome sized = run({"stipple", image, "--paper-size", "81x41mm", "--dot-size", "1mm",
                               "-o", folder.path("a.svg")});
    EXPECT_TRUE(sized.err.starts_with("2555 dots (")) << sized.err;
}

// A pen decides how large dots are drawn, and no distance.
TEST(Stipple, WithAPenAndAScaleIsTheSetWithoutThePenAndIsProven) {
    const Folder folder;
    const Names scaled{"stipple", kRaccoon, "--scale", "0.02", "--relax", "0", "--mode", "exact"};
    expect_success(joined(scaled, {"--quiet", "-o", folder.path("plain.txt")}));
    expect_success(
        joined(scaled, {"--quiet", "--dot-size", "0.5mm", "--paper-size", "A4", "--no-pen-path",
                        "-o", folder.path("pen.txt"), "-o", folder.path("pen.json")}));
    EXPECT_EQ(content_of(folder.path("pen.txt")), content_of(folder.path("plain.txt")));
    expect_success({"verify", folder.path("pen.json"), "--field", kRaccoon, "--light"});
}

TEST(Stipple, InExactTellsItsModeAndTheMetricThatItHas) {
    const Folder folder;
    const std::string image = grey_picture(folder, 2, 1, bytes({0, 128}));
    const std::string path = folder.path("a.json"), report = folder.path("report.json");
    expect_success({"stipple", image, "--mode", "exact", "--count", "100", "--relax", "2", "-o",
                    path, "--report", report, "--quiet"});
    const auto request = nlohmann::json::parse(content_of(report)).at("request");
    EXPECT_EQ(request.at("mode"), "exact");
    EXPECT_EQ(request.at("metric"), "min");
    EXPECT_EQ(request.at("lines_per_radius"), 1);
    const auto made = nlohmann::json::parse(content_of(path));
    EXPECT_EQ(made.at("mode"), "exact");
    EXPECT_EQ(made.at("command"),
              "lacuna stipple " + image + " --count 100 --mode exact --relax 2");
}

TEST(Stipple, OfOneDotSaysSo) {
    const Folder folder;
    const Outcome outcome = run({"stipple", kRaccoon, "--count", "1", "-o", folder.path("a.svg")});
    EXPECT_TRUE(outcome.err.starts_with("1 dot, ")) << outcome.err;
}

}  // namespace
