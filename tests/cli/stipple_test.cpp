// Given a picture, `lacuna stipple` makes dots that look like it, in every format and order.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/stippling.h"
#include "program.h"

namespace {

using namespace lacuna::tests;

TEST(Stipple, WarnsInOneLineOfDotsWithLessThanHalfOfTheInkOrMoreThanTwice) {
    const Folder folder;
    const std::string grey = grey_picture(folder, 1, 1, bytes({128}));
    const auto warning = [&](const Names& more, const Names& paper) {
        const Names words{"stipple", grey, "-o", folder.path("a.svg")};
        const std::string err = run(joined(joined(words, paper), more)).err;
        return err.starts_with("lacuna: ") ? err.substr(8, err.find('\n') - 8) : "";
    };
    // Within the margins and half of a pen of 1 mm 80 mm x 80 mm, half of it black, is 4051 dots.
    const Names square{"--paper-size", "121x101mm", "--margin", "10mm"};
    const Names a3{"--paper-size", "A3", "--margin", "10mm"};
    struct Case {
        Names drawn;
        std::string warning{};
        Names paper{};
    };
    const Names plain{"--relax", "0"};
    const std::string steeper = "; with this ink --gamma 2 keeps more contrast";
    const auto wider = [&](const std::string& pen) {
        return steeper + ", and --size-by-tone 0.5 --pen " + pen +
               " in place of --dot-size draws wider dots with this pen";
    };
    const std::vector<Case> cases{
        {joined(plain, {"--count", "100", "--dot-size", "1mm"}),
         "100 dots of 1mm have 2.5 % of the picture's ink: about 4060 dots or --dot-size 6.4mm "
         "would suit" +
             wider("1mm")},
        {joined(plain, {"--count", "1000", "--dot-size", "4mm"}),
         "1000 dots of 4mm have 426 % of the picture's ink: about 235 dots, --dot-size 1.9mm or "
         "--paper-size A4 would suit"},
        {joined(plain, {"--count", "100", "--dot-size", "1mm", "--gamma", "2"}),
         "100 dots of 1mm have 4.9 % of the picture's ink: about 2020 dots or --dot-size 4.5mm "
         "would suit"},
        {joined(plain, {"--count", "2100", "--dot-size", "1mm"})},
        {joined(plain, {"--count", "8000", "--dot-size", "1mm"})},
        {joined(plain, {"--dot-size", "1mm"})},
        {joined(plain, {"--count", "100"})},
        {{"--count", "100", "--dot-size", "1mm", "--quiet"}},
        {joined(plain, {"--count", "1500", "--dot-size", "2mm"}),
         "1500 dots of 2mm have 13 % of the picture's ink: about 12000 dots, --dot-size 5.7mm or "
         "--paper-size A6 would suit" +
             wider("2mm"),
         a3},
        {{"--count", "300", "--inks", "black:1mm"},
         "300 dots of these pens have 0.62 % of the picture's ink: about 48300 dots would suit" +
             steeper,
         a3},
        {{"--count", "300", "--path-line", "--dot-size", "1mm"},
         "lines of 1mm through 300 dots have 13 % of the picture's ink: about 18900 dots, "
         "--dot-size 7.9mm or --paper-size 56x71mm would suit" +
             steeper,
         a3},
        {{"--plot-time", "2min", "--inks", "black:1mm,red:2mm", "--path-line"},
         "lines of these pens through 377 dots have 14 % of the picture's ink: about 18700 dots or "
         "--paper-size 61x78mm would suit" +
             steeper,
         a3}};
    for (const Case& one : cases)
        EXPECT_EQ(warning(one.drawn, one.paper.empty() ? square : one.paper), one.warning);
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
    EXPECT_EQ(request.at("image_sha256").get<std::string>().size(), 64U);
    request.erase("image_sha256");
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
    // There are no more of them although there is time.
    const Outcome timed =
        run({"stipple", image, "--paper-size", "81x41mm", "--dot-size", "1mm", "--plot-time",
             "100h", "--seconds-per-dot", "1", "-o", folder.path("a.svg")});
    expect_has(timed.err, {"2555 dots (finished sooner than in 100 h: more would not suit), ",
                           " m, about 45 min on this plotter"});
    expect_has(sized.err, {" m, about 14 min on an AxiDraw V3"});
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
    expect_success({"verify", folder.path("pen.json"), "--field", kRaccoon});
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

TEST(Stipple, SaysThatDotsHaveWidthsOfNoPenThatThePictureIsBlackAndHowLongEachLayerTakes) {
    const Folder folder;
    const std::string dark = grey_picture(folder, 2, 1, bytes({5, 8}));
    const auto said = [&](const Names& options) {
        return run(joined({"stipple", dark, "--count", "20", "-o", folder.path("a.svg")}, options))
            .err;
    };
    expect_has(said({}), {"is 97 % black: --auto-levels shows more of it, and --invert draws "});
    for (const char* const levels : {"--auto-levels", "--white=0.1", "--quiet"})
        EXPECT_EQ(said({levels}).find("% black"), std::string::npos) << levels;
    const Names sizes{"--dot-size", "1mm..2mm", "--white=0.05"};
    expect_has(said(sizes), {" wide, which no one pen draws: for a plotter give --pen, "});
    EXPECT_EQ(said(joined(sizes, {"--pen", "0.5mm"})).find("no one pen"), std::string::npos);
    expect_has(said({"--pens", "1mm,2mm", "--white=0.05"}), {" (1mm ", ", and 1 change of pens) "});
    expect_has(content_of(folder.path("a.svg")), {"2mm\"", "<desc>pen path ", " m, about "});
}

TEST(Stipple, OfOneDotSaysSo) {
    const Folder folder;
    const Outcome outcome = run({"stipple", kRaccoon, "--count", "1", "-o", folder.path("a.svg")});
    EXPECT_TRUE(outcome.err.starts_with("1 dot, ")) << outcome.err;
}

}  // namespace
