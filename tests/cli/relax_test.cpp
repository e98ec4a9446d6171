// `lacuna relax`, and sample and stipple with --relax, make the same even sets and report how even.
#include <gtest/gtest.h>
#include <signal.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/expectations.h"
#include "cli/stippling.h"
#include "files/read_points.h"
#include "program.h"

namespace {

using namespace lacuna::test;
using lacuna::Point;

std::vector<Point> points_in(const std::string& path) {
    return lacuna::files::read_points(path);
}

TEST(Relax, GivenASetThenItMakesWhatSampleWithRelaxMakes) {
    const Folder folder;
    const std::string set = folder.path("set.npy"), even = folder.path("even.npy"),
                      at_once = folder.path("at_once.npy");
    const Names request{"sample", "--count", "500", "--torus", "--quiet", "-o"};
    Names words = request;
    words.push_back(set);
    ASSERT_EQ(run(words).exit_code, 0);
    words.back() = at_once;
    words.insert(words.end(), {"--relax", "7"});
    ASSERT_EQ(run(words).exit_code, 0);
    const Outcome outcome =
        run({"relax", set, "--torus", "--iterations", "7", "--quiet", "-o", even});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(points_in(even).size(), 500U);
    EXPECT_EQ(points_in(even), points_in(at_once));
    EXPECT_NE(points_in(even), points_in(set));
}

TEST(Relax, GivenDotsAndTheirPictureThenItMakesWhatStippleMakesByDefault) {
    const Folder folder;
    const std::string dots = folder.path("dots.npy"), even = folder.path("even.npy");
    ASSERT_EQ(
        stipple(kRaccoon, {"--count", "2000", "--relax", "0", "--metric", "mean"}, dots).exit_code,
        0);
    ASSERT_EQ(run({"relax", dots, kRaccoon, "--quiet", "-o", even}).exit_code, 0);
    const std::string by_default = folder.path("default.npy");
    ASSERT_EQ(run({"stipple", kRaccoon, "--count", "2000", "--quiet", "-o", by_default}).exit_code,
              0);
    EXPECT_EQ(points_in(even), points_in(by_default));
}

TEST(Relax, ReportsHowEvenTheSharesAre) {
    const Folder folder;
    const std::string report = folder.path("a.json");
    const Outcome outcome = run({"sample", "--count", "1000", "--torus", "--seed", "5", "--relax",
                                 "20", "--quiet", "-o", folder.path("a.npy"), "--report", report});
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
    ASSERT_EQ(run({"sample", "--count", "60", "--domain", "3x1", "-o", set}).exit_code, 0);
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

TEST(Relax, GivenWhiteThenNoDotIsThere) {
    const Folder folder;
    const std::string image = grey_picture(folder, 4, 1, bytes({0, 255, 255, 0}));
    const std::vector<Point> points = points_of(image, {"--count", "50", "--relax", "15"});
    ASSERT_EQ(points.size(), 50U);
    for (const Point& point : points) EXPECT_TRUE(point.x < 0.25 || point.x >= 0.75) << point.x;
}

TEST(Relax, GivenBadUsageThenOneLineSaysWhatIsAllowed) {
    const Folder folder;
    const std::string set = folder.path("set.txt");
    write_file(set, "0.5 0.5\n0.25 1.5\n");
    expect_one_error(run({"relax", set, "--iterations", "10001"}), 2,
                     {"--iterations 10001: ", "10000"});
    expect_one_error(run({"relax", set}), 2, {"(0.25, 1.5)", "must lie in the domain"});
    expect_one_error(run({"relax", set, "-o", set}), 2, {"--output", "another file"});
    expect_one_error(run({"relax", folder.path("none.txt")}), 3, {"none.txt"});
    expect_one_error(run({"relax", set, "--domain", "1x2", "--backend", "abacus"}), 2,
                     {"--backend abacus"});
    expect_one_error(run({"sample", "--count", "5", "--relax", "-1"}), 2, {"--relax -1"});
}

TEST(Relax, EndsOnASignalAndWritesNothing) {
    const Folder folder;
    const std::string set = folder.path("set.npy");
    ASSERT_EQ(run({"sample", "--count", "20000", "--quiet", "-o", set}).exit_code, 0);
    Program program({"relax", set, "--iterations", "10000", "-o", folder.path("even.npy")});
    ASSERT_TRUE(program.waits_for(SIGINT));
    program.send(SIGINT);
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.exit_code, 130);
    EXPECT_EQ(outcome.err, "lacuna: interrupted, nothing was written\n");
    EXPECT_EQ(folder.names(), Names{"set.npy"});
}

TEST(RelaxHelp, BeginsWithExamplesAndNamesEveryOption) {
    const Outcome outcome = run({"relax", "--help"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_LT(outcome.out.find("Examples:"), outcome.out.find("Options:"));
    for (const char* option :
         {"POINTS", "IMAGE", "--iterations", "--domain", "--torus", "--invert", "--gamma",
          "--min-importance", "--dot-size", "--paper-size", "--margin", "--dpi", "--backend",
          "--device", "--threads", "--output", "--report", "--quiet"})
        EXPECT_NE(outcome.out.find(option, outcome.out.find("Positionals:")), std::string::npos)
            << option;
}

}  // namespace
