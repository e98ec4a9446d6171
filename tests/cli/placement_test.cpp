// What `lacuna sample` says and writes of domains, places, classes, kept points and tiles: a table
// of options, words and members of its .json and its report. That options arrive is in
// arrives_test.cpp, and what verify says in verdicts_test.cpp.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "cli/pictures.h"
#include "expectations.h"
#include "files/read_points.h"
#include "program.h"

namespace placement_test {

using namespace lacuna;
using namespace lacuna::tests;
using Json = nlohmann::json;

struct Saying {
    Words options;
    Words says;  // on standard error
    std::vector<std::pair<std::string, Json>> members;
};

class Placement : public testing::Test {
protected:
    std::string file(const char* name, const std::string& content) const {
        write_file(folder_.path(name), content);
        return folder_.path(name);
    }
    void expect(const std::vector<Saying>& rows) const {
        const std::string set = folder_.path("a.json"), report = folder_.path("r.json");
        for (const auto& [options, says, members] : rows) {
            SCOPED_TRACE(testing::PrintToString(options));
            const Outcome outcome =
                run(joined(joined({"sample"}, options), {"-o", set, "--report", report}));
            ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
            expect_has(outcome.err, says);
            const Json written = Json::parse(content_of(set)),
                       told = Json::parse(content_of(report));
            for (const auto& [member, value] : members) {
                const Json::json_pointer at(member);
                EXPECT_EQ((written.contains(at) ? written : told).value(at, Json()), value)
                    << member;
            }
        }
    }

    const Folder folder_;
    const std::string black_ = file("black.pgm", pgm(1, 1, bytes({0})));
    const std::string lake_ =
        file("lake.geojson", R"({"type":"Polygon","coordinates":)"
                             R"([[[12,3],[88,14],[95,60],[60,92],[20,70],[3,40],[12,3]]]})");
    const Words in_lake_{"--radius", "3", "--domain", "40,40+9x9"};
};

TEST_F(Placement, OfADomainIsAroundWhatIsGiven) {
    const std::string map = file("map.txt", "0 0\n100 0\n100 80\n0 80\n");
    const std::string far = file("far.txt",
                                 "448251 5411932\n448900 5411950\n448800 5412400\n\n"
                                 "449000 5411200\n449400 5411200\n449400 5411500\n");
    const std::string plot =
        file("plot.txt", "448000.25 5411000.5\n448002.25 5411000.5\n448002.25 5411002.5\n");
    const std::string line = file("line.txt", "2 50\n90 50\n"),
                      kept = file("kept.csv", "x,y\n30,55\n");
    const std::string pond = file("pond.txt", "0.3 0.3\n0.45 0.3\n0.45 0.45\n");
    const std::string half =
        file("half.svg", "<svg viewBox='0 0 20 10'><rect y='5' width='10' height='5'/></svg>");
    const std::string mask = file("mask.pgm", pgm(2, 1, bytes({255, 0})));
    const auto of = [](double width, double height) {
        return std::vector<std::pair<std::string, Json>>{{"/width", width}, {"/height", height}};
    };
    const auto at = [&](double x0, double y0, double width, double height) {
        auto all = of(width, height);
        all.insert(all.end(), {{"/x0", x0}, {"/y0", y0}});
        return all;
    };
    expect(
        {{{"--radius", "4", "--inside", map}, {}, of(100, 80)},
         {{"--radius", ".2", "--inside", map, "--domain", "1x1"}, {}, of(1, 1)},
         {{"--radius", "4", "--inside", lake_}, {}, of(95, 92)},
         {{"--radius", "4", "--outside", lake_}, {}, of(95, 92)},
         {{"--radius", "4", "--avoid", lake_ + ":6"}, {}, of(95, 92)},
         {{"--radius", "1", "--near", line + ":5", "--keep", kept}, {}, at(-3, 45, 98, 10)},
         {{"--radius", "20", "--inside", far}, {}, at(448251, 5411200, 1149, 1200)},
         {{"--radius", ".1", "--inside", plot}, {}, at(448000.25, 5411000.5, 8, 8)},
         {{"--radius", "90", "--domain", "448000,5411000+2000x1500"},
          {},
          {{"/x0", 448000},
           {"/options/y0", 5411000},
           {"/command", "lacuna sample --radius 90 --domain 448000,5411000+2000x1500"}}},
         {{"--radius", "90", "--domain", "2000x1500"}, {}, {{"/x0", nullptr}}},
         {{"--radius", "4", "--inside", map, "--inside", lake_, "--outside", pond, "--edge",
           "0.25"},
          {},
          {{"/options/inside", {map, lake_}}, {"/options/outside", pond}, {"/request/edge", 0.25}}},
         {{"--radius", "0.05", "--mask", mask, "--border", "0.01"},
          {},
          {{"/command", "lacuna sample --radius 0.05 --mask " + mask + " --border 0.01"},
           {"/options/mask", mask},
           {"/options/border", 0.01}}}});
    expect({{{"--count", "100", "--inside", half},
             {},
             {{"/request/inside", half}, {"/width", 20}, {"/height", 10}}}});
    const double edge = Json::parse(content_of(folder_.path("r.json")))["request"]["edge"];
    EXPECT_NEAR(edge, std::sqrt(0.69656 * 10 * 5 / 100) / 16, 0.002);  // of the part that is open
}

TEST_F(Placement, OfAPictureIsTheSameOnAnyDomain) {
    const auto dots_on = [](const std::string& domain) {
        const std::string svg =
            run({"sample", "--radius", "90", "--domain", domain, "--format", "svg"}).out;
        return svg.substr(svg.find("</metadata>"));
    };
    EXPECT_EQ(dots_on("448000,5411000+2000x1500"), dots_on("2000x1500"));
}

TEST_F(Placement, OfClassesAndNeighboursIsCounted) {
    const std::string west = file("west.csv", "x,y\n0.999,0.5\n0.94,0.2\n-3,0.5\n");
    const std::string far = file("far.csv", "x,y\n0.94,0.2\n");
    const std::string kinds = file("kinds.csv", "x,y,class\n0.999,0.5,a\n0.9,0.2,b\n0.8,0.2,b\n");
    const auto east = [](const Words& more) { return joined({"--domain", "1,0+1x1"}, more); };
    const Words two{"--class", "a:2", "--class", "b:1", "--count", "200"};
    expect({{{"--class", "a:0.05:1:3", "--class", "b:0.03:1:12"},
             {"15 points (a 3, b 12), "},
             {{"/classes/0/count", 3}, {"/classes/1/count", 12}, {"/options/counts", {3, 12}}}},
            {east({"--keep", west, "--radius", "0.05"}),
             {", beside 1 kept outside, "},
             {{"/options/keep", west}, {"/options/kept", 0}, {"/options/neighbours", 1}}},
            // The distances, and so the neighbours, are known only when the set is made.
            {east({"--keep", west, "--count", "60"}),
             {", beside 2 kept outside, "},
             {{"/options/neighbours", 2}}},
            {east({"--keep", far, "--radius", "0.05"}), {}, {{"/options/neighbours", nullptr}}},
            {{"--class", "a:0.4", "--class", "b:0.1", "--between", "union", "--count", "300"},
             {", distances 0."},
             {}}});
    const double kept =
        Json::parse(content_of(folder_.path("r.json"))).at("request").at("distances")[1][1];
    EXPECT_LT(kept, 0.1);
    expect_has(
        run(joined({"sample", "--keep", kinds, "--seeds", "0..1", "-o", folder_.path("{seed}.csv")},
                   east(two)))
            .err,
        {", beside up to 3 kept outside, "});
}

TEST_F(Placement, ThatHasNoPlaceIsSaid) {
    const std::string drawn = "has no open place wider than twice the --edge), ";
    const std::string none = "0 points (the domain, [40, 49) x [40, 49), " + drawn;
    expect({{joined(in_lake_, {"--outside", lake_}), {none}, {}},
            {joined(in_lake_, {"--outside", lake_, "--progressive"}), {none}, {}},
            {{"--radius", "3", "--domain", "0,192+64x64", "--inside", lake_},
             {"0 points (", drawn},
             {}},
            {{"--radius", "3", "--domain", "0,192+64x64", "--near", lake_ + ":2"},
             {"0 points (", drawn},
             {}},
            {joined(in_lake_, {"--mask", black_}), {"0 points (the mask is black all over), "}, {}},
            {{"--class", "reed:3", "--class", "tree:4", "--count", "5", "--domain", "40,40+9x9",
              "--outside", "tree:" + lake_},
             {"has no open place for tree wider than"},
             {{"/classes/1/count", 0}}}});
    for (const char* const end : {"txt", "csv", "npy", "ply", "json"}) {
        const std::string path = folder_.path(std::string("a.") + end);
        const Words asked = joined(in_lake_, {"--mask", black_});
        expect_success(joined(joined({"sample", "--quiet", "-o", path}, asked),
                              {"-o", folder_.path("a.svg")}));
        EXPECT_TRUE(files::read_points(path).points.empty()) << end;
        expect_success(joined({"verify", path}, asked));
        // The next chunk keeps what there is: nothing.
        expect_success({"sample", "--radius", "3", "--domain", "74,10+64x64", "--keep", path, "-o",
                        folder_.path("b.csv")});
    }
    expect_has(run(joined(joined({"sample"}, in_lake_), {"--mask", black_, "-o", "-"})).err,
               {"0 points ("});
}

TEST_F(Placement, OfClassesIsInFiles) {
    const auto path = [&](const char* end) { return folder_.path(std::string("a.") + end); };
    expect_success({"sample", "--quiet", "--class", "trees:0.05", "--class", "bushes:0.02:2",
                    "--torus", "-o", path("csv"), "-o", path("json"), "-o", path("svg"), "-o",
                    path("ply")});
    expect_has(content_of(path("csv")), {"x,y,class\n", ",trees\n", ",bushes\n"});
    expect_has(content_of(path("svg")), {"inkscape:label=\"2 bushes\""});
    expect_has(content_of(path("ply")), {"property uchar class\n"});
    const Json set = Json::parse(content_of(path("json")));
    EXPECT_EQ(set["classes"][1]["name"], "bushes");
    EXPECT_EQ(set["class"].size(), set["points"].size());
    EXPECT_EQ(set["command"], "lacuna sample --class trees:0.05 --class bushes:0.02:2 --torus");
    expect_success({"sample", "--quiet", "--stretch", "0.3:0.03@0", "-o", path("svg")});
    // A third of the radii: of 512 points.
    expect_has(content_of(path("svg")), {"a51.2 5.12 0 1 0 102.4000 0.0000"});
}

// In a chunk outlines lie in the plane, for verify, too; on another domain a page is stretched.
TEST_F(Placement, OfAPageIsInThePlaneOfChunksAndStretchedElsewhere) {
    const std::string page = file("page.svg",
                                  "<svg xmlns='http://www.w3.org/2000/svg' width='100' "
                                  "height='100'><rect y='80' width='30' height='20'/></svg>");
    const std::string set = folder_.path("chunk.json");
    expect_success({"sample", "--quiet", "--chunk", "0,0", "--chunk-size", "40", "--radius", "3",
                    "--outside", page, "-o", set});
    expect_success({"verify", set, "--outside", page});
    for (const Point& point : files::read_points(set).points)
        EXPECT_FALSE(point.x < 30 && point.y < 20);
    expect({{{"--radius", "5", "--outside", page, "--domain", "200x100"},
             {"an SVG page of 100 x 100 is stretched over the domain: 2 times across and 1 times"},
             {}},
            {{"--radius", "5", "--outside", page, "--domain", "200x200"}, {}, {}}});
    EXPECT_EQ(run({"sample", "--radius", "5", "--outside", page, "-o", set}).err.find("stretched"),
              std::string::npos);
}

TEST_F(Placement, OfObstaclesMayBeOfOneClass) {
    const std::string road = file("road.txt", "0.5 0\n0.5 1\n"), set = folder_.path("a.json");
    const Words avoided{"--avoid", "a:" + road + ":0.2", "--avoid", "b:" + road + ":0.05"};
    expect_success(joined({"sample", "--quiet", "--class", "a:0.05", "--class", "b:0.02",
                           "--domain", "1x1", "-o", set},
                          avoided));
    expect_success(joined({"verify", set}, avoided));
    const files::PointsOfFile made = files::read_points(set);
    std::array<double, 2> least{1, 1};
    for (std::size_t i = 0; i < made.points.size(); ++i) {
        double& own = least[made.classes.of_point[i]];
        own = std::min(own, std::abs(made.points[i].x - 0.5));
    }
    EXPECT_GE(least[0], 0.2);
    EXPECT_GE(least[1], 0.05);
    EXPECT_LT(least[1], 0.06);
}

// A kept object has the size that its radius says, and keeps it when its file is written again.
TEST_F(Placement, OfSizesHasTheRadiusOfEachObject) {
    const Words kinds{"--class", "trees:0.04..0.08/5", "--class", "grass:0.01"};
    const auto path = [&](const std::string& name) { return folder_.path(name); };
    const auto sample = [&](const Words& more) {
        return joined(joined({"sample", "--seed", "3"}, kinds), more);
    };
    const std::string json = path("a.json");
    EXPECT_EQ(run(sample({"-o", path("a.csv"), "-o", path("a.ply"), "-o", path("a.geojson"), "-o",
                          json, "--report", path("report.json")}))
                  .err.find("(trees 0"),
              std::string::npos);
    const files::PointsOfFile set = files::read_points(json);
    EXPECT_EQ(Json::parse(content_of(json))["options"]["class_names"],
              (Words{"trees", "trees", "trees", "trees", "trees", "grass"}));
    EXPECT_EQ(Json::parse(content_of(path("report.json")))["classes"][4]["radius"], 0.08);
    for (std::size_t i = 0; i < set.radii.size(); ++i) {
        constexpr std::array<double, 6> kRadii{0.04, 0.05, 0.06, 0.07, 0.08, 0.01};
        ASSERT_NEAR(set.radii[i], kRadii[set.classes.of_point[i]], 1e-9);
    }
    EXPECT_EQ(set.radii.size(), set.points.size());
    expect_success({"verify", json});
    for (const char* const name : {"a.csv", "a.ply", "a.geojson"}) {
        SCOPED_TRACE(name);
        expect_success(joined({"verify", path(name)}, kinds));
        const std::string kept = path("kept.json");
        expect_success(sample({"--quiet", "--keep", path(name), "-o", kept}));
        EXPECT_EQ(files::read_points(kept).classes.of_point, set.classes.of_point);
        const std::string ordered = path(std::string("ordered-") + name);
        expect_success({"order", path(name), "--quiet", "-o", ordered});
        expect_success(joined({"verify", ordered}, kinds));
    }
    const std::string wrong = file("wrong.csv", "x,y,radius,class\n0.5,0.5,0.045,trees\n");
    expect_has(
        run(sample({"--keep", wrong, "-o", path("b.csv")})).err,
        {"point 0 of the class trees has the radius 0.045: must be that of one of its sizes"});
    const std::string none = file("none.csv", "x,y,class\n0.5,0.5,trees\n");
    expect_has(run(sample({"--keep", none, "-o", path("b.csv")})).err, {"needs a column radius"});
    expect_has(run({"relax", path("a.csv"), "--dot-size", "2mm", "-o", path("b.csv")}).err,
               {"the column radius would be lost"});
}

TEST_F(Placement, OfNumbersOfClassesIsReadStrictly) {
    const std::string json = folder_.path("a.json");
    expect_success({"sample", "--quiet", "--class", "a:0.2:1:2", "--class", "b:0.1", "-o", json});
    Json set = Json::parse(content_of(json));
    const auto with_numbers = [&](const Json& numbers) {
        set["options"]["counts"] = numbers;
        write_file(json, set.dump());
        return run({"verify", json}).err;
    };
    EXPECT_EQ(with_numbers({2.5, nullptr}),
              "lacuna: " + json + ": \"counts\" has 2.5: must be a number of points\n");
    EXPECT_EQ(with_numbers({2}),
              "lacuna: " + json + ": \"counts\" has 1 values: must be 2, one for each class\n");
}

TEST_F(Placement, OfDistancesMayNameItsClassesInAnyFormat) {
    const std::string matrix = folder_.path("m.csv"), csv = folder_.path("a.csv");
    const auto made = [&](const std::string& content, const std::string& first,
                          const std::string& second) {
        write_file(matrix, content);
        return run({"sample", "--class", first, "--class", second, "--between", matrix, "--quiet",
                    "--format", "csv"});
    };
    const std::string expected = made("0.2,0.1\n0.1,0.3\n", "trees", "rocks").out;
    for (const char* const same :
         {"0.2;0.1\n0.1;0.3\n", "0.2\t0.1\n0.1\t0.3\n", "0.2  0.1\n0.1 0.3\n",
          ",trees,rocks\ntrees,0.2,0.1\nrocks,0.1,0.3\n",
          "class;rocks;trees\ntrees;0.1;0.2\nrocks;0.3;0.1\n",
          "\"rocks\",\"trees\"\n0.3,0.1\n0.1,0.2\n", "rocks,0.3,0.1\ntrees,0.1,0.2\n"})
        EXPECT_EQ(made(same, "trees", "rocks").out, expected) << same;
    EXPECT_EQ(made("trees,rocks\n0.2,0.1\n0.1,0.3\n", "rocks", "trees").out,
              made("0.3,0.1\n0.1,0.2\n", "rocks", "trees").out);
}

TEST_F(Placement, OfStrokesAndObstaclesIsReadFromTheirFiles) {
    const std::string map = file("map.svg",
                                 "<svg viewBox='0 0 60 40'><g stroke='black' "
                                 "stroke-width='8'><line x1='30' x2='30' y2='40'/></g></svg>");
    const std::string out = folder_.path("a.csv");
    const auto made = [&](const Words& options) {
        return run(joined({"sample", "--radius", "1", "--quiet", "-o", out}, options)).err;
    };
    // In units of a domain of the page's shape.
    for (const char* const option : {"--avoid", "--near"}) {
        EXPECT_EQ(made({option, map + ":stroke", "--domain", "120x80"}), "");
        for (const Point& point : files::read_points(out).points)
            EXPECT_EQ(std::abs(point.x - 60) < 8, std::string(option) == "--near") << point.x;
    }
    expect_has(run({"sample", "--class", "a:1", "--inside", "a:" + lake_, "-o", out, "--report",
                    lake_ + ".json"})
                   .err,
               {" points"});
    EXPECT_NE(
        run({"sample", "--class", "a:1", "--inside", "a:" + lake_, "-o", out, "--report", lake_})
            .exit_code,
        0);
    EXPECT_EQ(content_of(lake_).front(), '{');
    expect_has(run({"sample", "--class", "a:1", "--inside", "rocks:a.txt", "-o", out}).err,
               {"rocks:a.txt: "});
    // As people's files are: semicolons, names in capitals and quotes, and a row's own name.
    const std::string rocks = folder_.path("rocks.csv");
    const auto avoiding = [&](const std::string& content) {
        write_file(rocks, content);
        EXPECT_EQ(made({"--avoid", rocks, "--domain", "9x9"}), "");
        return content_of(out);
    };
    EXPECT_EQ(avoiding("\"X\";\"Y\";\"Radius\"\n\"a\";5;2;2\n\"b\";5;7;0\n"),
              avoiding("x,y,radius\n5,2,2\n5,7,0\n"));
}

TEST_F(Placement, OfTilesBeginsWithTheirFrame) {
    const Outcome made =
        run({"sample", "--radius", "0.05", "--torus", "--frame", "0.1", "--seeds", "4..7", "-o",
             folder_.path("{seed}.json"), "--report", folder_.path("all.json")});
    ASSERT_EQ(made.exit_code, 0) << made.err;
    const Json four = Json::parse(content_of(folder_.path("4.json"))),
               seven = Json::parse(content_of(folder_.path("7.json")));
    const std::size_t kept = four["options"]["kept"];
    EXPECT_EQ(four["options"]["frame"], 0.1);
    expect_has(made.err, {", " + std::to_string(kept) + " of them kept, "});
    EXPECT_EQ(Json::parse(content_of(folder_.path("all.json")))["request"]["kept"], kept);
    Request tile{.domain = {1, 1, Boundary::torus}, .radius = 0.05, .seed = 4};
    const TileRing frame = tile_ring(tile, 0.1);
    tile.seed = 7;
    tile.keep = frame.points;
    EXPECT_EQ(kept, frame.points.size());
    const std::vector<Point> points = files::read_points(folder_.path("7.json")).points;
    EXPECT_EQ(points, sample(tile).points);
    EXPECT_NE(four["points"], seven["points"]);
    expect_success({"verify", folder_.path("7.json")});
}

}  // namespace placement_test
