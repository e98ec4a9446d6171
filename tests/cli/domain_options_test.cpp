// Given files that say where points may lie, `lacuna sample` fills just that.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/pictures.h"
#include "files/read_points.h"
#include "program.h"

namespace domain_options_test {

using namespace lacuna;
using namespace lacuna::tests;
using Names = std::vector<std::string>;
using Json = nlohmann::json;

// Runs `lacuna sample ARGUMENTS... -o OUTPUT`.
Outcome sample_to(const std::string& output, Names arguments) {
    arguments.insert(arguments.begin(), "sample");
    arguments.insert(arguments.end(), {"--quiet", "-o", output});
    return tests::run(arguments);
}

std::vector<Point> points_of(const Folder& folder, Names arguments) {
    const std::string path = folder.path("points.npy");
    const Outcome outcome = sample_to(path, std::move(arguments));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.exit_code == 0 ? files::read_points(path) : std::vector<Point>{};
}

TEST(SampleInsidePolygons, MayBeGivenSeveralFilesAndOthersToLeaveOut) {
    const Folder folder;
    const auto square = [&](const std::string& name, const std::string& low,
                            const std::string& high) {
        write_file(folder.path(name), low + " " + low + "\n" + high + " " + low + "\n" + high +
                                          " " + high + "\n" + low + " " + high + "\n");
        return folder.path(name);
    };
    const std::string low = square("low.txt", "0", "0.6"), high = square("high.txt", "0.4", "1"),
                      pond = square("pond.txt", "0.3", "0.45");
    const Names where{"--inside", low, "--inside", high, "--outside", pond};
    Names arguments = where;
    arguments.insert(arguments.end(), {"--radius", "0.03"});
    const std::string json = folder.path("a.json");
    ASSERT_EQ(sample_to(json, arguments).exit_code, 0);
    const auto options = Json::parse(content_of(json)).at("options");
    EXPECT_EQ(options.at("inside"), Json({low, high}));
    EXPECT_EQ(options.at("outside"), pond);
    Names proof{"verify", json};
    proof.insert(proof.end(), where.begin(), where.end());
    const Outcome proven = tests::run(proof);
    EXPECT_EQ(proven.exit_code, 0) << proven.out;
    proof.resize(proof.size() - 2);  // without the pond
    const Outcome asked = tests::run(proof);
    EXPECT_EQ(asked.exit_code, 2);
    EXPECT_NE(asked.err.find("made with --outside " + pond), std::string::npos) << asked.err;
}

TEST(SampleInsidePolygons, HasALargerDomainWhereTheyReachBeyondTheDefault) {
    const Folder folder;
    const std::string map = folder.path("map.txt");
    write_file(map, "0 0\n100 0\n100 80\n0 80\n");
    const std::vector<Point> asked =
        points_of(folder, {"--inside", map, "--radius", "4", "--domain", "100x80"});
    EXPECT_GT(asked.size(), 300U);
    EXPECT_EQ(points_of(folder, {"--inside", map, "--radius", "4"}), asked);
    EXPECT_FALSE(
        points_of(folder, {"--inside", map, "--radius", "0.1", "--domain", "1x1"}).empty());
}

// On the upper edges as on the lower ones.
TEST(KeptPoints, MayLieOnAllEdgesOfAPolygon) {
    const Folder folder;
    const std::string plot = folder.path("plot.geojson"), fence = folder.path("fence.csv");
    write_file(plot, R"({"type":"Polygon","coordinates":[[[10,10],[50,10],[50,50],[10,50],)"
                     R"([10,10]]]})");
    std::string posts = "x,y\n";
    for (int i = 10; i < 50; i += 4)
        for (const auto& [x, y] :
             {std::pair{i, 10}, std::pair{50, i}, std::pair{60 - i, 50}, std::pair{10, 60 - i}})
            posts += std::to_string(x) + "," + std::to_string(y) + "\n";
    write_file(fence, posts);
    const std::string made = folder.path("made.csv");
    for (const char* const option : {"--inside", "--outside"}) {
        const Names asked{option, plot, "--radius", "4", "--keep", fence, "--domain", "60x60"};
        const Outcome outcome = sample_to(made, asked);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        Names proof{"verify", made};
        proof.insert(proof.end(), asked.begin(), asked.end());
        EXPECT_EQ(tests::run(proof).exit_code, 0);
    }
}

// A domain large enough is chosen for a plot of 2 m in a map's coordinates.
TEST(SampleInsidePolygons, MayBeSmallAndFarFrom0) {
    const Folder folder;
    const std::string plot = folder.path("plot.geojson"), json = folder.path("a.json");
    write_file(plot, R"({"type":"Polygon","coordinates":[[[448000.25,5411000.5],)"
                     R"([448002.25,5411000.5],[448002.25,5411002.5],[448000.25,5411002.5],)"
                     R"([448000.25,5411000.5]]]})");
    ASSERT_EQ(sample_to(json, {"--inside", plot, "--radius", "0.1"}).exit_code, 0);
    EXPECT_EQ(tests::run({"verify", json, "--inside", plot}).exit_code, 0);
    const auto set = Json::parse(content_of(json));
    EXPECT_GT(set["points"].size(), 250U);
    for (const Json& point : set["points"])
        EXPECT_TRUE(point[0] >= 448000.25 && point[0] <= 448002.25 && point[1] >= 5411000.5 &&
                    point[1] <= 5411002.5);
}

// The same places, by whatever option, have the same domain: one around them.
TEST(SampleAroundPlaces, HasTheirDomainWhateverOptionReadsThem) {
    const Folder folder;
    const std::string lake = folder.path("lake.geojson"), report = folder.path("report.json");
    write_file(lake, R"({"type":"Polygon","coordinates":[[[12,3],[88,14],[95,60],[60,92],[20,70],)"
                     R"([3,40],[12,3]]]})");
    for (const Names& option :
         {Names{"--inside", lake}, Names{"--outside", lake}, Names{"--avoid", lake + ":6"}}) {
        const std::vector<Point> points =
            points_of(folder, {option[0], option[1], "--radius", "4", "--report", report});
        EXPECT_GT(points.size(), 40U) << option[0];
        const Json request = Json::parse(content_of(report))["request"];
        EXPECT_EQ(request["width"], 95) << option[0];
        EXPECT_EQ(request["height"], 92) << option[0];
    }
}

TEST(SampleInsidePolygons, TakesAnEdgeAndStretchesAPageOverTheDomain) {
    const Folder folder;
    const std::string svg = folder.path("half.svg");
    write_file(svg, "<svg viewBox='0 0 20 10'><rect width='20' height='5'/></svg>");
    const std::string report = folder.path("report.json");
    const std::vector<Point> points =
        points_of(folder, {"--inside", svg, "--radius", "0.05", "--domain", "1x1", "--edge", "0.25",
                           "--report", report});
    EXPECT_TRUE(std::all_of(points.begin(), points.end(), [](Point at) { return at.y > 0.25; }));
    const Json request = Json::parse(content_of(report))["request"];
    EXPECT_EQ(request["inside"], svg);
    EXPECT_EQ(request["edge"], 0.25);
    points_of(folder, {"--inside", svg, "--count", "100", "--report", report});
    const double edge = Json::parse(content_of(report))["request"]["edge"];
    EXPECT_NEAR(edge, std::sqrt(0.69656 * 20 * 5 / 100) / 16, 0.002);  // the page is 20 x 10
}

TEST(ASetOnADomain, TellsACommandThatMakesItAgain) {
    const Folder folder;
    const std::string mask = grey_picture(folder, 2, 1, bytes({255, 0}));
    const std::string path = folder.path("a.json");
    ASSERT_EQ(sample_to(path, {"--mask", mask, "--radius", "0.05", "--border", "0.01"}).exit_code,
              0);
    const Json made = Json::parse(content_of(path));
    EXPECT_EQ(made["command"], "lacuna sample --radius 0.05 --mask " + mask + " --border 0.01");
    EXPECT_EQ(made["options"]["mask"], mask);
    EXPECT_EQ(made["options"]["border"], 0.01);
}

}  // namespace domain_options_test
