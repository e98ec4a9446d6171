// Given a domain whose lower left corner is not (0, 0), points come out there, files say so, and
// the other commands read it.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "expectations.h"
#include "files/read_points.h"
#include "program.h"

namespace corner_test {

using namespace lacuna;
using namespace lacuna::tests;
using Json = nlohmann::json;
using Names = std::vector<std::string>;

const std::string kMap = "448000,5411000+2000x1500";

std::vector<Point> points_of(const std::string& path) {
    return files::read_points(path);
}

void sample_to(const std::string& path, Names arguments) {
    arguments.insert(arguments.begin(), "sample");
    arguments.insert(arguments.end(), {"--quiet", "-o", path});
    expect_success(arguments);
}

TEST(ACorner, IsWhereThePointsOfEachFormatBegin) {
    const Folder folder;
    sample_to(folder.path("plain.json"), {"--radius", "90", "--domain", "2000x1500"});
    std::vector<Point> expected = points_of(folder.path("plain.json"));
    for (Point& point : expected) point = {448000 + point.x, 5411000 + point.y};
    for (const std::string format : {"txt", "csv", "npy", "ply", "json"}) {
        const std::string path = folder.path("a." + format);
        sample_to(path, {"--radius", "90", "--domain", kMap});
        EXPECT_EQ(points_of(path), expected) << format;
    }
    const Json json = Json::parse(content_of(folder.path("a.json")));
    EXPECT_EQ(json["x0"], 448000);
    EXPECT_EQ(json["y0"], 5411000);
    EXPECT_EQ(json["options"]["x0"], 448000);
    EXPECT_EQ(json["options"]["y0"], 5411000);
    EXPECT_EQ(json["command"], "lacuna sample --radius 90 --domain " + kMap);
    EXPECT_FALSE(Json::parse(content_of(folder.path("plain.json"))).contains("x0"));
    // A picture shows the same dots on the same page.
    const auto dots_of = [&](const std::string& domain) {
        const std::string svg =
            run({"sample", "--radius", "90", "--domain", domain, "--format", "svg"}).out;
        return svg.substr(svg.find("</metadata>"));
    };
    EXPECT_EQ(dots_of(kMap), dots_of("2000x1500"));
}

TEST(ACorner, MayBeNegative) {
    const Folder folder;
    sample_to(folder.path("a.npy"), {"--radius", "1", "--domain", "-10,-20.5+5x5"});
    sample_to(folder.path("b.npy"), {"--radius", "1", "--domain=-10,-20.5+5x5"});
    const std::vector<Point> points = points_of(folder.path("a.npy"));
    EXPECT_EQ(points, points_of(folder.path("b.npy")));
    for (const Point& point : points)
        EXPECT_TRUE(point.x >= -10 && point.x < -5 && point.y >= -20.5 && point.y < -15.5);
}

TEST(ACorner, IsReadBackFromAJsonByEveryCommand) {
    const Folder folder;
    const std::string set = folder.path("a.json");
    sample_to(set, {"--radius", "90", "--domain", kMap, "--torus"});
    const std::string where = "2000 x 1500 at (448000, 5411000), torus";
    const Outcome proof = run({"verify", set});
    EXPECT_EQ(proof.exit_code, 0) << proof.out;
    expect_has(line_of(proof.out, "domain"), {where});
    const Json verdict = Json::parse(run({"verify", set, "--json"}).out)["sets"][0];
    EXPECT_EQ(verdict["domain"]["x0"], 448000);
    EXPECT_EQ(verdict["domain"]["y0"], 5411000);
    expect_has(line_of(run({"analyze", set, "--quiet"}).out, "domain"), {where});
    EXPECT_EQ(Json::parse(run({"analyze", set, "--json", "--quiet"}).out)["domain"]["y0"], 5411000);
    for (const Names& command : {Names{"relax", set, "--iterations", "3"}, Names{"order", set}}) {
        Names arguments = command;
        const std::string path = folder.path(command[0] + ".json");
        arguments.insert(arguments.end(), {"--quiet", "-o", path});
        expect_success(arguments);
        const Json json = Json::parse(content_of(path));
        EXPECT_EQ(json["x0"], 448000) << command[0];
        EXPECT_EQ(json["y0"], 5411000) << command[0];
        EXPECT_EQ(run({"verify", path, "--radius", "1", "--distances-only"}).exit_code, 0)
            << command[0];
    }
    // Without a .json the option says it, and a set that lies elsewhere is refused.
    sample_to(folder.path("a.csv"), {"--radius", "90", "--domain", kMap, "--torus"});
    const Names proven{"verify", folder.path("a.csv"), "--radius", "90", "--torus"};
    Names there = proven;
    there.insert(there.end(), {"--domain", kMap});
    EXPECT_EQ(run(there).exit_code, 0);
    there.back() = "448100,5411000+2000x1500";
    const Outcome moved = run(there);
    EXPECT_EQ(moved.exit_code, 1);
    expect_has(line_of(moved.out, "verdict"),
               {"outside the domain [448100, 450100) x [5411000, 5412500)"});
    expect_has(run({"analyze", folder.path("a.csv")}).err,
               {"lies outside the domain [0, 1] x [0, 1]: give --domain"});
}

const std::string kParcels =
    R"({"type":"MultiPolygon","coordinates":[[[[448251,5411932],[448900,5411950],[448800,5412400],)"
    R"([448251,5411932]]],[[[449000,5411200],[449400,5411200],[449400,5411500],[449000,5411200]]]]})";

TEST(Outlines, FarFrom0HavePointsWhereTheyLie) {
    const Folder folder;
    const std::string map = folder.path("map.geojson"), set = folder.path("a.json");
    write_file(map, kParcels);
    sample_to(set, {"--inside", map, "--radius", "20"});
    const Json json = Json::parse(content_of(set));
    EXPECT_EQ(json["x0"], 448251);
    EXPECT_EQ(json["y0"], 5411200);
    EXPECT_EQ(json["width"], 449400 - 448251);
    EXPECT_EQ(json["height"], 5412400 - 5411200);
    EXPECT_EQ(run({"verify", set, "--inside", map}).exit_code, 0);
    // A domain that is stated cuts the outlines.
    const std::string part = folder.path("part.csv");
    sample_to(part, {"--inside", map, "--radius", "20", "--domain", "448500,5411900+600x300"});
    EXPECT_EQ(run({"verify", part, "--inside", map, "--radius", "20", "--domain",
                   "448500,5411900+600x300"})
                  .exit_code,
              0);
    const Outcome elsewhere = run({"sample", "--inside", map, "--radius", "20", "--domain", "9x9"});
    expect_has(elsewhere.err, {"0 points (the domain, [0, 9) x [0, 9), has no open place"});
    // The same outlines at (0, 0) have the same points.
    const std::string plain = folder.path("plain.txt"), here = folder.path("here.csv");
    write_file(plain, "0 732\n649 750\n549 1200\n\n749 0\n1149 0\n1149 300\n");
    sample_to(here, {"--inside", plain, "--radius", "20"});
    std::vector<Point> expected = points_of(here);
    for (Point& point : expected) point = {448251 + point.x, 5411200 + point.y};
    EXPECT_EQ(points_of(set), expected);
}

TEST(Outlines, OfObstaclesAndKeptPointsLieAtTheCornerToo) {
    const Folder folder;
    write_file(folder.path("map.geojson"), kParcels);
    write_file(folder.path("rocks.csv"), "x,y,radius\n448700,5412000,60\n448600,5412050,30\n");
    write_file(folder.path("trees.txt"), "448650 5412150\n448400 5411980\n");
    write_file(folder.path("pond.txt"), "448500 5411900\n448560 5412000\n448500 5412100\n");
    const Names where{"--inside",  folder.path("map.geojson"), "--avoid",  folder.path("rocks.csv"),
                      "--outside", folder.path("pond.txt"),    "--border", "8",
                      "--keep",    folder.path("trees.txt")};
    Names arguments = where;
    arguments.insert(arguments.end(), {"--radius", "15"});
    const std::string set = folder.path("a.json");
    sample_to(set, arguments);
    EXPECT_EQ(points_of(set)[0], (Point{448650, 5412150}));
    Names proof{"verify", set};
    proof.insert(proof.end(), where.begin(), where.end());
    const Outcome proven = run(proof);
    EXPECT_EQ(proven.exit_code, 0) << proven.out << proven.err;
    write_file(folder.path("trees.txt"), "650 150\n");
    const Outcome refused = run({"sample", "--inside", folder.path("map.geojson"), "--keep",
                                 folder.path("trees.txt"), "--radius", "15", "--progressive"});
    EXPECT_EQ(refused.err,
              "lacuna: --keep point 0 at (650, 150): with a progressive order must lie in the "
              "domain, [448251, 449400] x [5411200, 5412400]\n");
}

TEST(Outlines, WithoutAnAreaNeedADomain) {
    const Folder folder;
    write_file(folder.path("path.txt"), "448000 5411000\n448900 5411000\n");
    const Names avoid{"sample", "--avoid", folder.path("path.txt") + ":5", "--radius", "20"};
    EXPECT_EQ(run(avoid).err,
              "lacuna: --domain missing: the places given lie in [448000, 448900] x [5411000, "
              "5411000], which has no area: give a domain that has one\n");
}

}  // namespace corner_test
