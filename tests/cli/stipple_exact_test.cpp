// Given --mode exact, `lacuna stipple` makes the sets that `lacuna sample --field` makes.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>
#include <lacuna/pictures.h>
#include <lacuna/verify.h>

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/stippling.h"
#include "files/read_points.h"
#include "program.h"

namespace {

using namespace lacuna::test;
using lacuna::Point;

// A gradient of 24 x 16 pixels, white on the right.
std::string gradient(const Folder& folder) {
    std::string pixels;
    for (int row = 0; row < 16; ++row)
        for (int column = 0; column < 24; ++column)
            pixels += static_cast<char>(column * 11 + row / 4);
    return grey_picture(folder, 24, 16, pixels);
}

// Bytes of the points that a command makes, as .npy.
std::string points_by(const Folder& folder, const Names& command, const Names& arguments) {
    const std::string path = folder.path("points.npy");
    const Outcome outcome = run(joined(joined(command, arguments), {"--quiet", "-o", path}));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.exit_code == 0 ? content_of(path) : "";
}

TEST(ExactStipple, MakesTheSetThatSampleMakesOnTheFieldOfThePicture) {
    const Folder folder;
    const std::string image = gradient(folder);
    const std::vector<Names> requests{
        {"--scale", "0.03"},
        {"--count", "400", "--seed", "5"},
        {"--count", "300", "--invert", "--gamma", "1.7", "--torus"},
        {"--scale", "0.04", "--black", "0.1", "--white", "0.6", "--min-importance", "0.01"},
        {"--scale", "0.03", "--auto-levels", "--limit", "50", "--lines-per-radius", "3"},
        {"--scale", "0.03", "--round-size", "1", "--backend", "reference"}};
    for (const Names& request : requests) {
        const std::string expected = points_by(folder, {"sample", "--field", image}, request);
        EXPECT_EQ(points_by(folder, {"stipple", image, "--mode", "exact", "--relax", "0"}, request),
                  expected)
            << request[0] << ' ' << request[1];
        EXPECT_NE(points_by(folder, {"stipple", image, "--relax", "0"}, request), expected);
    }
}

TEST(ExactStipple, IsRelaxedAsTheSetOfSampleIs) {
    const Folder folder;
    const std::string image = gradient(folder);
    const Names request{"--count", "400", "--seed", "2"};
    EXPECT_EQ(points_by(folder, {"stipple", image, "--mode", "exact"}, request),
              points_by(folder, {"sample", "--field", image, "--relax", "15", "--mode", "exact"},
                        request));
    const Names three = joined({"--relax", "3"}, request);
    EXPECT_EQ(points_by(folder, {"stipple", image, "--mode", "exact"}, three),
              points_by(folder, {"sample", "--field", image, "--mode", "exact"}, three));
}

TEST(ExactStipple, LeavesNoGapWhereCellsLeaveSome) {
    const Folder folder;
    const std::string image = gradient(folder);
    const lacuna::Field field = lacuna::importance_of(lacuna::read_picture(image), lacuna::Tone{});
    lacuna::Claim claim;
    claim.height = 2.0 / 3;
    claim.field = &field;
    claim.scale = 0.02;
    const auto dots_of = [&](const std::string& mode) {
        return points_of(image, {"--scale", "0.02", "--mode", mode});
    };
    const std::vector<Point> exact = dots_of("exact");
    EXPECT_TRUE(lacuna::prove(exact, claim).maximal);
    const std::vector<Point> cells = dots_of("cells");
    EXPECT_FALSE(lacuna::prove(cells, claim).covered);
    EXPECT_LT(cells.size(), exact.size());
}

TEST(ExactStipple, WithoutACountMakesAsManyDotsAsSuitThePicture) {
    const Folder folder;
    const std::string image = gradient(folder);
    const std::string path = folder.path("a.npy");
    expect_success({"stipple", image, "-o", path, "--quiet", "--relax", "0"});
    const std::size_t count = lacuna::files::read_points(path).size();
    const Outcome outcome = run({"stipple", image, "--mode", "exact", "-o", folder.path("a.svg")});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_TRUE(outcome.err.starts_with(
        std::to_string(count) +
        " dots (chosen for the picture: --count gives another number), scale "))
        << outcome.err;
}

TEST(ExactStipple, TellsItsModeAndTheMetricThatItHas) {
    const Folder folder;
    const std::string image = gradient(folder);
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

TEST(ExactStipple, SizesDotsAndOrdersThemForAPen) {
    const Folder folder;
    const std::string image = gradient(folder);
    const std::string path = folder.path("a.csv");
    ASSERT_EQ(stipple(image,
                      {"--mode", "exact", "--count", "150", "--pen-path", "--paper-size", "A4",
                       "--dot-size", "radius"},
                      path)
                  .exit_code,
              0);
    const std::string csv = content_of(path);
    EXPECT_TRUE(csv.starts_with("x,y,radius,")) << csv.substr(0, 40);
    EXPECT_EQ(lacuna::files::read_points(path).size(), 150U);
}

}  // namespace
