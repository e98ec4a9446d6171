// `lacuna relax`, and sample and stipple with --relax, make the same even sets and report how even.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/stippling.h"
#include "files/read_points.h"
#include "program.h"

namespace {

using namespace lacuna::tests;
using lacuna::Point;

std::vector<Point> points_in(const std::string& path) {
    return lacuna::files::read_points(path).points;
}

TEST(Relax, MakesOfASetWhatSampleAndStippleMakeOfThatStart) {
    const Folder folder;
    const std::string set = folder.path("set.npy"), even = folder.path("even.npy"),
                      at_once = folder.path("at_once.json"), report = folder.path("report.json");
    const Words torus{"sample", "--count", "300", "--torus", "--quiet"};
    const Words dots{"stipple", kRaccoon, "--count", "2000", "--quiet"};
    struct Row {
        Words makes, start, moves, at_once;
    };
    const Words moves{"--torus", "--iterations", "3"}, cells{"--relax", "0", "--metric", "mean"};
    for (const auto& [makes, start, moving, whole] :
         std::vector<Row>{{torus, {}, moves, {"--relax", "3", "--start", "exact"}},
                          {dots, cells, {kRaccoon}, {"--start", "cells"}},
                          {torus,
                           {},
                           joined(moves, {"--gaussian=150"}),
                           {"--relax", "3", "--start", "exact", "--gaussian"}}}) {
        expect_success(joined(joined(makes, start), {"-o", set}));
        expect_success(joined(joined(makes, whole), {"-o", at_once}));
        const Outcome outcome = run(
            joined(joined({"relax", set}, moving), {"--quiet", "-o", even, "--report", report}));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "");
        EXPECT_EQ(points_in(even), points_in(at_once));
        EXPECT_NE(points_in(even), points_in(set));
    }
    const auto json = nlohmann::json::parse(content_of(report));
    EXPECT_EQ(json.at("request").at("gaussian"), 150);
    EXPECT_EQ(json.at("request").at("gaussian_distance"), 0.9);
    EXPECT_GT(json.at("seconds").at("descend"), 0);
    EXPECT_NE(content_of(at_once).find("--relax 3 --gaussian 150"), std::string::npos);
    expect_success(joined(dots, {"-o", set}));
    expect_success(joined(dots, {"--start", "cells", "-o", at_once}));
    EXPECT_NE(points_in(set), points_in(at_once));
}

TEST(Relax, ReportsHowEvenTheSharesAre) {
    const Folder folder;
    const std::string report = folder.path("a.json");
    const Outcome outcome =
        run({"sample", "--count", "1000", "--torus", "--seed", "5", "--relax", "20", "--start",
             "exact", "--quiet", "-o", folder.path("a.npy"), "--report", report});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto json = nlohmann::json::parse(content_of(report));
    const auto& cv = json.at("relax").at("capacity_cv");
    EXPECT_NEAR(cv.at("before"), 0.142, 0.02);
    EXPECT_LT(cv.at("after"), 0.04);
    EXPECT_LT(cv.at("after_in_voronoi_cells"), 0.055);
    EXPECT_EQ(json.at("request").at("relax"), 20);
    EXPECT_EQ(json.at("maximal"), false);
    EXPECT_GT(json.at("radius"), 0.6 * 1.0746 / 31.6);
    EXPECT_EQ(json.at("radius"), json.at("relax").at("least_distance"));
    EXPECT_GT(json.at("seconds").at("assign"), 0);
    EXPECT_GT(json.at("seconds").at("move"), 0);
}

TEST(Relax, TellsOfAFileInOneLineAndReportsPointsThatWereRead) {
    const Folder folder;
    const std::string set = folder.path("set.json"), even = folder.path("even.json"),
                      report = folder.path("report.json");
    expect_success({"sample", "--count", "60", "--domain", "3x1", "-o", set});
    const Outcome outcome = run({"relax", set, "-o", even, "--report", report});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(outcome.err.starts_with("60 points, 15 iterations, ")) << outcome.err;
    EXPECT_TRUE(outcome.err.ends_with(" s, cpu -> " + even + "\n")) << outcome.err;
    const auto json = nlohmann::json::parse(content_of(report));
    EXPECT_EQ(json.at("request").at("width"), 3);
    EXPECT_EQ(json.at("request").at("relax"), 15);
    EXPECT_EQ(json.at("count"), 60);
    EXPECT_LT(json.at("relax").at("capacity_cv").at("after"),
              json.at("relax").at("capacity_cv").at("before"));
    EXPECT_EQ(nlohmann::json::parse(content_of(even)).at("radius"),
              json.at("relax").at("least_distance"));
}

}  // namespace
