// Given a sequence of pictures, `lacuna stipple --frames` makes dots that glide from one to the
// next.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "cli/stippling.h"
#include "expectations.h"
#include "files/read_points.h"
#include "program.h"

namespace {

using namespace lacuna::tests;
using lacuna::Point;

// A white bar on grey, which moves to the right.
std::string frame(const Folder& folder, int number) {
    std::string pixels(40UL * 30, static_cast<char>(128));
    for (std::size_t row = 0; row < 30; ++row)
        for (std::size_t column = 0; column < 4; ++column)
            pixels[row * 40 + 5 + static_cast<std::size_t>(number) + column] =
                static_cast<char>(255);
    const std::string made = grey_picture(folder, 40, 30, pixels);
    const std::string path = folder.path("in/" + std::to_string(number) + ".pgm");
    std::filesystem::create_directories(folder.path("in"));
    std::filesystem::rename(made, path);
    return path;
}

TEST(StippleFrames, EachDotKeepsItsIndexAndMovesLittle) {
    const Folder folder;
    for (int number = 0; number < 3; ++number) frame(folder, number);
    const Outcome outcome = run({"stipple", "--frames", folder.path("in/*.pgm"), "--count", "800",
                                 "--seed", "3", "-o", folder.path("{frame}.npy")});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 3) << "a line a picture";
    const Folder ten;
    for (int number = 9; number < 11; ++number) frame(ten, number);
    std::filesystem::rename(ten.path("in/9.pgm"), ten.path("in/09b.pgm"));
    std::filesystem::rename(ten.path("in/10.pgm"), ten.path("in/10a.pgm"));
    frame(ten, 9);
    const std::string lines = run({"stipple", "--frames", ten.path("in/*.pgm"), "--count", "9",
                                   "-o", ten.path("{frame}.npy")})
                                  .err;
    EXPECT_LT(lines.find("/9.npy"), lines.find("/09b.npy")) << lines;
    EXPECT_LT(lines.find("/09b.npy"), lines.find("/10a.npy")) << lines;
    const auto json_of = [&](const char* name) { return content_of(folder.path(name)); };
    ASSERT_EQ(run({"stipple", "--frames", folder.path("in/*.pgm"), "--count", "80", "-o",
                   folder.path("{frame}.json")})
                  .exit_code,
              0);
    EXPECT_NE(json_of("1.json").find("--frames"), std::string::npos) << "how it was made";
    std::vector<Point> before = lacuna::files::read_points(folder.path("0.npy")).points;
    EXPECT_EQ(before, points_of(folder.path("in/0.pgm"),
                                {"--count", "800", "--seed", "3", "--relax", "15"}));
    const double spacing = std::sqrt(0.75 / 800);
    for (const char* name : {"1.npy", "2.npy"}) {
        const std::vector<Point> dots = lacuna::files::read_points(folder.path(name)).points;
        ASSERT_EQ(dots.size(), 800U);
        std::vector<double> moves;
        for (std::size_t i = 0; i < dots.size(); ++i)
            moves.push_back(std::hypot(dots[i].x - before[i].x, dots[i].y - before[i].y) / spacing);
        std::sort(moves.begin(), moves.end());
        EXPECT_LT(moves[400], 0.3) << name;
        EXPECT_GT(moves.back(), 0.1) << name << ": dots near the bar move";
        before = dots;
    }
}

TEST(StippleFrames, MayBeKeptInsideAndDrawnByPens) {
    const Folder folder;
    for (int number = 0; number < 2; ++number) frame(folder, number);
    const Names sequence{
        "stipple",      "--frames", folder.path("in/*.pgm"), "--count", "300",
        "--paper-size", "A6",       "--keep-inside",         "-o",      folder.path("{frame}.csv")};
    for (const Names& way : {Names{"--pens", "0.5mm,0.8mm"}, Names{"--dot-size", "0.5mm"},
                             Names{"--size-by-tone", "0.5"}}) {
        ASSERT_EQ(run(joined(sequence, way)).exit_code, 0) << way.front();
        for (const char* name : {"0.csv", "1.csv"}) {
            const std::string rows = content_of(folder.path(name));
            EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 301) << name << way.front();
            std::filesystem::remove(folder.path(name));
        }
    }
}

}  // namespace
