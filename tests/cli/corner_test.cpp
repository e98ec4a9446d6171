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

TEST(Outlines, FarFrom0HavePointsWhereTheyLie) {
    const Folder folder;
    const std::string map = folder.path("map.txt"), set = folder.path("a.json");
    write_file(map,
               "448251 5411932\n448900 5411950\n448800 5412400\n\n"
               "449000 5411200\n449400 5411200\n449400 5411500\n");
    sample_to(set, {"--inside", map, "--radius", "20"});
    const Json json = Json::parse(content_of(set));
    EXPECT_EQ(json["x0"], 448251);
    EXPECT_EQ(json["y0"], 5411200);
    EXPECT_EQ(json["width"], 449400 - 448251);
    EXPECT_EQ(json["height"], 5412400 - 5411200);
    EXPECT_EQ(run({"verify", set, "--inside", map}).exit_code, 0);
    expect_has(run({"sample", "--inside", map, "--radius", "20", "--domain", "9x9"}).err,
               {"0 points (the domain, [0, 9) x [0, 9), has no open place"});
    // The same outlines at (0, 0) have the same points.
    const std::string plain = folder.path("plain.txt"), here = folder.path("here.csv");
    write_file(plain, "0 732\n649 750\n549 1200\n\n749 0\n1149 0\n1149 300\n");
    sample_to(here, {"--inside", plain, "--radius", "20"});
    std::vector<Point> expected = points_of(here);
    for (Point& point : expected) point = {448251 + point.x, 5411200 + point.y};
    EXPECT_EQ(points_of(set), expected);
}

}  // namespace corner_test
