// Classes of points and obstacles, as a user of the command meets them: columns, reports, verdicts
// and refusals. That options arrive is in arrives_test.cpp, and that sets are proven from their
// files in made_with_test.cpp.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "expectations.h"
#include "files/read_points.h"
#include "files/read_whole.h"
#include "program.h"

namespace placement_test {

using namespace lacuna;
using namespace lacuna::tests;
using Json = nlohmann::json;

const Words kWood{"--class", "trees:0.05", "--class", "bushes:0.02:2", "--class", "grass:0.006"};

Outcome sample_with(const Words& arguments) {
    return tests::run(joined({"sample", "--quiet"}, arguments));
}

Outcome verify_with(const Words& arguments) {
    return tests::run(joined({"verify"}, arguments));
}

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

TEST(Classes, OfACountAreReportedWithTheDistancesThatTheyKeep) {
    const Folder folder;
    const Outcome outcome = tests::run({"sample", "--class", "a:0.4", "--class", "b:0.1",
                                        "--between", "union", "--count", "300", "-o",
                                        folder.path("a.csv"), "--report", folder.path("r.json")});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const Json report = Json::parse(files::read_whole(folder.path("r.json")));
    const double kept = report.at("request").at("distances")[1][1];
    char told[64];
    std::snprintf(told, sizeof told, ", distances %.4g times those given", kept / 0.1);
    EXPECT_NE(outcome.err.find(told), std::string::npos) << outcome.err << told;
}

TEST(Classes, HaveTheirNumbersOfPointsInFilesAndProofs) {
    const Folder folder;
    const std::string csv = folder.path("a.csv"), json = folder.path("a.json");
    const Words asked{"--class",         "trees:0.05:1:12", "--class",
                      "bushes:0.03::20", "--class",         "grass:0.01:2"};
    ASSERT_EQ(sample_with(joined(asked, {"-o", csv, "-o", json})).exit_code, 0);
    const Json set = Json::parse(files::read_whole(json));
    EXPECT_EQ(set["classes"][0]["count"], 12);
    EXPECT_EQ(set["classes"][1]["count"], 20);
    EXPECT_EQ(set["options"]["counts"], (Json{12, 20, nullptr}));
    const std::string verdict = "a maximal Poisson-disk set of 3 classes with their numbers";
    for (const Words& options : {Words{json}, joined({csv}, asked)}) {
        const Outcome proven = verify_with(options);
        EXPECT_EQ(proven.exit_code, 0) << proven.out;
        EXPECT_NE(proven.out.find(verdict), std::string::npos) << proven.out;
    }
    Words other = asked;
    other[1] = "trees:0.05:1:13";
    const Outcome refuted = verify_with(joined({csv, "--json"}, other));
    EXPECT_EQ(refuted.exit_code, 1);
    const Json found = Json::parse(refuted.out)["sets"][0];
    EXPECT_EQ(found["verdict"], "refused: class trees has 12 points in place of 13");
    EXPECT_EQ(found["miscounted"], "trees");
    // What a .json says of classes is read as strictly as options are.
    const std::string whole = files::read_whole(json);
    const auto with_numbers = [&](const std::string& numbers) {
        const std::string counts = "\"counts\":";
        const std::size_t begin = whole.find(counts) + counts.size(), end = whole.find(']', begin);
        write_file(json, whole.substr(0, begin) + numbers + whole.substr(end + 1));
        return verify_with({json}).err;
    };
    EXPECT_EQ(with_numbers("[12.5,20,null]"),
              "lacuna: " + json + ": \"counts\" has 12.5: must be a number of points\n");
    EXPECT_EQ(with_numbers("[12,20]"),
              "lacuna: " + json + ": \"counts\" has 2 values: must be 3, one for each class\n");
    EXPECT_EQ(sample_with({"--class", "a:0.1:1:2:3", "-o", csv}).err,
              "lacuna: --class a:0.1:1:2:3: must be NAME:RADIUS, NAME:RADIUS:WEIGHT or "
              "NAME:RADIUS:WEIGHT:N\n");
    EXPECT_EQ(sample_with({"--class", "a:0.1:1:900", "--class", "b:0.1", "-o", csv}).exit_code, 2);
}

TEST(Classes, HaveOneMaskEach) {
    const Folder folder;
    const std::string left = folder.path("left.pgm"), top = folder.path("top.pgm");
    write_file(left, std::string("P5 2 1 255\n") + '\xff' + '\0');
    write_file(top, std::string("P5 1 2 255\n") + '\xff' + '\0');
    const std::string json = folder.path("a.json");
    ASSERT_EQ(sample_with({"--class", "trees:0.05", "--class", "grass:0.01", "--domain", "1x1",
                           "--mask", "trees:" + left, "--mask", top, "-o", json})
                  .exit_code,
              0);
    EXPECT_EQ(verify_with({json, "--mask", top}).exit_code, 1);
    EXPECT_EQ(verify_with({json, "--mask", "trees:" + left, "--mask", "trees:" + top}).err,
              "lacuna: --mask trees:" + top + ": a second mask of class trees\n");
}

TEST(Classes, AreNamedInFilesAndProvenFromThem) {
    const Folder folder;
    const std::string csv = folder.path("a.csv"), json = folder.path("a.json");
    const std::string svg = folder.path("a.svg"), ply = folder.path("a.ply");
    ASSERT_EQ(sample_with(joined(kWood, {"--between", "union", "--torus", "-o", csv, "-o", json,
                                         "-o", svg, "-o", ply}))
                  .exit_code,
              0);
    std::vector<std::string> lines = lines_of(files::read_whole(csv));
    ASSERT_EQ(lines.front(), "x,y,class");
    std::map<std::string, std::size_t> counts;
    for (std::size_t i = 1; i < lines.size(); ++i)
        ++counts[lines[i].substr(lines[i].rfind(',') + 1)];
    ASSERT_EQ(counts.size(), 3U);
    EXPECT_LT(counts["trees"], counts["bushes"]);
    EXPECT_LT(counts["bushes"], counts["grass"]);

    const Json set = Json::parse(files::read_whole(json));
    EXPECT_EQ(set["classes"][1]["name"], "bushes");
    EXPECT_EQ(set["classes"][1]["count"], counts["bushes"]);
    EXPECT_EQ(set["class"].size(), lines.size() - 1);
    EXPECT_EQ(set["command"],
              "lacuna sample --class trees:0.05 --class bushes:0.02:2 --class grass:0.006 "
              "--between union --torus");
    EXPECT_NE(files::read_whole(svg).find("inkscape:label=\"2 bushes\""), std::string::npos);
    EXPECT_NE(files::read_whole(ply).find("property uchar class\n"), std::string::npos);

    // A .json says what was asked for, a .csv needs the options.
    EXPECT_EQ(verify_with({json}).exit_code, 0);
    const Words options = joined({csv, "--between", "union", "--torus"}, kWood);
    const Outcome proven = verify_with(options);
    EXPECT_EQ(proven.exit_code, 0) << proven.out;
    EXPECT_NE(proven.out.find("a maximal Poisson-disk set of 3 classes"), std::string::npos);

    // A point less, or one of another class, is refuted, and named.
    const std::string first = lines[1];
    lines.erase(lines.begin() + 1);
    std::string less;
    for (const std::string& line : lines) less += line + "\n";
    write_file(csv, less);
    const Outcome lacking = verify_with(options);
    EXPECT_EQ(lacking.exit_code, 1);
    EXPECT_NE(lacking.out.find("there is room for a point of class " +
                               first.substr(first.rfind(',') + 1) + " at "),
              std::string::npos)
        << lacking.out;
    write_file(csv, less + first.substr(0, first.rfind(',')) + ",trees\n");
    const Outcome changed = verify_with(options);
    EXPECT_EQ(changed.exit_code, 1);
    EXPECT_NE(changed.out.find("of class trees, are closer than"), std::string::npos)
        << changed.out;
}

TEST(Classes, HaveTheirKeptPointsFirst) {
    const Folder folder;
    const std::string csv = folder.path("a.csv"), kept = folder.path("kept.csv");
    write_file(kept, "x,y,class\n0.25,0.5,grass\n0.75,0.5,trees\n");
    const Words keep{"--keep", kept};
    ASSERT_EQ(sample_with(joined(joined(kWood, keep), {"-o", csv})).exit_code, 0);
    EXPECT_TRUE(files::read_whole(csv).starts_with("x,y,class\n0.25,0.5,grass\n0.75,0.5,trees\n"));
    EXPECT_EQ(verify_with(joined(joined({csv}, kWood), keep)).exit_code, 0);
}

TEST(Classes, AreInEveryFileOfSeeds) {
    const Folder folder;
    ASSERT_EQ(
        sample_with(joined(kWood, {"--seeds", "3..4", "-o", folder.path("{seed}.csv")})).exit_code,
        0);
    ASSERT_EQ(sample_with(joined(kWood, {"--seed", "4", "-o", folder.path("own.csv")})).exit_code,
              0);
    EXPECT_EQ(files::read_whole(folder.path("4.csv")), files::read_whole(folder.path("own.csv")));
    EXPECT_NE(files::read_whole(folder.path("3.csv")), files::read_whole(folder.path("own.csv")));
}

TEST(Classes, AreRefusedInOneLine) {
    const Folder folder;
    const auto refusal = [](const Words& arguments) {
        const Outcome outcome = sample_with(joined(arguments, {"--format", "csv"}));
        EXPECT_NE(outcome.exit_code, 0);
        return outcome.err;
    };
    EXPECT_EQ(refusal({"--class", "trees"}),
              "lacuna: --class trees: needs a radius: give NAME:RADIUS\n");
    EXPECT_EQ(refusal({"--class", "a:1:1:1"}),
              "lacuna: --class a with 1 points: is the only class: give a limit instead\n");
    EXPECT_EQ(refusal({"--class", "a:0"}),
              "lacuna: --class a:0: its radius must be a finite number over 0\n");
    EXPECT_EQ(refusal({"--class", "a:1:x"}),
              "lacuna: --class a:1:x: its weight must be a number, such as 0.01 or 1e-2\n");
    write_file(folder.path("m.csv"), "");
    EXPECT_EQ(refusal({"--class", "a", "--class", "b", "--between", folder.path("m.csv"),
                       "--inside-by-radius"}),
              "lacuna: --between 0 distances: must be a matrix of 2 x 2, for as many classes\n");
    write_file(folder.path("m.csv"), "1,2\n2\n");
    EXPECT_EQ(refusal({"--class", "a", "--class", "b", "--between", folder.path("m.csv")}),
              "lacuna: " + folder.path("m.csv") + ":2: 1 column: the first line has 2\n");
    write_file(folder.path("m.csv"), "a;2,5;1\nb;1;3\n");
    EXPECT_EQ(refusal({"--class", "a", "--class", "b", "--between", folder.path("m.csv")}),
              "lacuna: " + folder.path("m.csv") +
                  ":1: column 2 is \"2,5\": must be a finite number, such as 0.25\n");
    write_file(folder.path("m.csv"), "a,x\n2,1\n1,3\n");
    EXPECT_EQ(refusal({"--class", "a", "--class", "b", "--between", folder.path("m.csv")}),
              "lacuna: " + folder.path("m.csv") +
                  ":3: \"x\" must be a number, such as 0.25, or a class (a or b)\n");
    write_file(folder.path("m.csv"), "a,a\n2,1\n1,3\n");
    EXPECT_EQ(refusal({"--class", "a", "--class", "b", "--between", folder.path("m.csv")}),
              "lacuna: " + folder.path("m.csv") + ": must name each class once, or none\n");
    EXPECT_EQ(refusal({"--class", "a:1", "--between", folder.path("m.csv")}),
              "lacuna: --class a:1: must have no radius with distances from a file: give NAME or "
              "NAME::WEIGHT\n");
    write_file(folder.path("kept.csv"), "x,y\n0.5,0.5\n");
    EXPECT_EQ(refusal(joined(kWood, {"--keep", folder.path("kept.csv")})),
              "lacuna: " + folder.path("kept.csv") +
                  ": its points have no class: with --class a .csv needs a column class with "
                  "names, as lacuna writes it\n");
    write_file(folder.path("kept.csv"), "x,y,class\n0.5,0.5,rocks\n");
    EXPECT_EQ(refusal(joined(kWood, {"--keep", folder.path("kept.csv")})),
              "lacuna: " + folder.path("kept.csv") +
                  ": has points of the class rocks, which no --class names\n");
}

TEST(Classes, MayBeNamedInTheFileOfTheirDistances) {
    const Folder folder;
    const std::string file = folder.path("m.csv"), csv = folder.path("a.csv");
    const auto made_with = [&](const std::string& matrix, const Words& classes) {
        write_file(file, matrix);
        const Outcome outcome = sample_with(joined(classes, {"--between", file, "-o", csv}));
        EXPECT_EQ(outcome.exit_code, 0) << matrix << outcome.err;
        return content_of(csv);
    };
    const Words trees_first{"--class", "trees", "--class", "rocks"};
    const Words rocks_first{"--class", "rocks", "--class", "trees"};
    const std::string expected = made_with("0.2,0.1\n0.1,0.3\n", trees_first);
    for (const char* const same :
         {"0.2;0.1\n0.1;0.3\n", "0.2\t0.1\n0.1\t0.3\n", "0.2  0.1\n0.1 0.3\n",
          ",trees,rocks\ntrees,0.2,0.1\nrocks,0.1,0.3\n",
          "class;rocks;trees\ntrees;0.1;0.2\nrocks;0.3;0.1\n",
          "\"rocks\",\"trees\"\n0.3,0.1\n0.1,0.2\n", "rocks,0.3,0.1\ntrees,0.1,0.2\n"})
        EXPECT_EQ(made_with(same, trees_first), expected) << same;
    const std::string turned = made_with("0.3,0.1\n0.1,0.2\n", rocks_first);
    EXPECT_EQ(made_with("trees,rocks\n0.2,0.1\n0.1,0.3\n", rocks_first), turned);
}

TEST(Classes, AreCountedInTheSummaryAndTheReport) {
    const Folder folder;
    const std::string report = folder.path("r.json");
    const Outcome outcome = tests::run({"sample", "--class", "a:0.05:1:3", "--class", "b:0.03:1:12",
                                        "-o", folder.path("a.csv"), "--report", report});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(outcome.err.starts_with("15 points (a 3, b 12), ")) << outcome.err;
    EXPECT_EQ(Json::parse(content_of(report))["classes"],
              Json::parse(R"([{"name": "a", "count": 3}, {"name": "b", "count": 12}])"));
}

TEST(Obstacles, AreNamedAsPolygonsWhereAPointIsInOne) {
    const Folder folder;
    const std::string rocks = folder.path("rocks.csv"), csv = folder.path("a.csv");
    write_file(rocks, "x,y,radius\n0.3,0.3,0.1\n");
    write_file(csv, "x,y\n0.31,0.3\n");
    const Outcome refuted =
        verify_with({csv, "--avoid", rocks, "--domain", "1x1", "--radius", "1"});
    EXPECT_EQ(refuted.exit_code, 1);
    EXPECT_NE(refuted.out.find("where the polygons let none lie"), std::string::npos)
        << refuted.out;
}

TEST(Near, NeedsDistancesAndReachesAsFarAsTheDomain) {
    const Folder folder;
    const std::string path = folder.path("path.svg"), lots = folder.path("lots.csv");
    write_file(path, "<svg viewBox='0 0 2 1'><polyline points='0,0.5 2,0.5'/></svg>");
    const std::string csv = folder.path("a.csv"), json = folder.path("a.json");
    const auto refusal = [&](const std::string& near) {
        return sample_with({"--near", near, "--radius", "0.02", "-o", csv}).err;
    };
    EXPECT_EQ(refusal(path), "lacuna: --near " + path +
                                 ": needs a distance, as in FILE:2.5: how far points may be from "
                                 "its lines\n");
    EXPECT_EQ(
        refusal("a.foo:2"),
        "lacuna: --near a.foo: must end in .svg, .svgz, .geojson, .geojsonl, .json or .txt\n");
    EXPECT_EQ(refusal(path + ":0"),
              "lacuna: --near " + path + ":0: the distance must be a finite number over 0\n");
    write_file(lots, "x,y,radius\n0.5,0.9,0\n");
    EXPECT_EQ(refusal(lots), "lacuna: --near " + lots +
                                 ": must have a point with a distance over 0, or points may lie "
                                 "nowhere\n");
    // A kept point as far as that is near enough, and the domain reaches as far.
    const std::string line = folder.path("line.txt"), kept = folder.path("kept.csv");
    write_file(line, "2 50\n90 50\n");
    write_file(kept, "x,y\n30,55\n");
    const Outcome strip =
        sample_with({"--near", line + ":5", "--keep", kept, "--radius", "1", "-o", json});
    EXPECT_EQ(strip.exit_code, 0) << strip.err;
    EXPECT_EQ(verify_with({json, "--near", line + ":5", "--keep", kept}).exit_code, 0);
    const Json domain = Json::parse(files::read_whole(json));
    EXPECT_EQ(domain["width"], 98);
    EXPECT_EQ(domain["height"], 10);
    EXPECT_EQ(domain["x0"], -3);
    EXPECT_EQ(domain["y0"], 45);
}

// As people's files are: semicolons, names in capitals and quotes, and a row's own name.
TEST(Obstacles, AreReadAsPointsAre) {
    const Folder folder;
    const auto made_with = [&](const std::string& content) {
        write_file(folder.path("rocks.csv"), content);
        const Outcome outcome = sample_with(
            {"--avoid", folder.path("rocks.csv"), "--radius", "0.03", "--format", "csv"});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return outcome.out;
    };
    EXPECT_EQ(made_with("\"X\";\"Y\";\"Radius\"\n\"a\";0.5;0.25;0.2\n\"b\";0.5;0.75;0\n"),
              made_with("x,y,radius\n0.5,0.25,0.2\n0.5,0.75,0\n"));
}

TEST(Obstacles, AreRefusedInOneLine) {
    const Folder folder;
    const auto refusal = [](const Words& arguments) {
        const Outcome outcome = sample_with(joined(arguments, {"--radius", "0.1"}));
        EXPECT_NE(outcome.exit_code, 0);
        return outcome.err;
    };
    const std::string rocks = folder.path("rocks.csv");
    write_file(rocks, "x,y\n0.5,0.5\n");
    EXPECT_EQ(refusal({"--avoid", rocks}),
              "lacuna: --avoid " + rocks +
                  ": has no column radius: give FILE:WIDTH, the distance from its points\n");
    EXPECT_EQ(refusal({"--avoid", rocks + ":-1"}),
              "lacuna: --avoid " + rocks + ":-1: the width must be a finite number over 0\n");
    write_file(folder.path("a.txt"), "0 0\n1 1\n");
    EXPECT_EQ(refusal({"--avoid", folder.path("a.txt")}),
              "lacuna: --avoid " + folder.path("a.txt") +
                  ": needs a width, as in FILE:2.5: how far points stay from its lines\n");
    write_file(rocks, "x,y,radius\n0.5,0.5,big\n");
    EXPECT_EQ(refusal({"--avoid", rocks}),
              "lacuna: " + rocks +
                  ":2: column \"radius\" is \"big\": must be a finite number, such as 0.25\n");
    write_file(rocks, "x,y,radius\n0.5,0.5\n");
    EXPECT_EQ(refusal({"--avoid", rocks}),
              "lacuna: " + rocks + ":2: 2 columns: the header has 3\n");
    write_file(rocks, "x,size\n0.5,0.5\n");
    EXPECT_EQ(refusal({"--avoid", rocks + ":.1"}),
              "lacuna: " + rocks +
                  ":1: the columns are \"x,size\": two must be called x and y, lon and lat, or "
                  "easting and northing\n");
}

// Roads as wide as the drawing shows them, in units of the page or of a domain of its shape.
TEST(Strokes, OfADrawingAreAvoidedOrFilledInTheirWidth) {
    const Folder folder;
    const std::string map = folder.path("map.svg"), csv = folder.path("a.csv");
    write_file(map,
               "<svg viewBox='0 0 60 40'><circle cx='10' cy='30' r='5'/>"
               "<g id='roads' stroke='black' stroke-width='8'><line x1='30' x2='30' y2='40'/>"
               "<line y1='5' x2='60' y2='5' stroke-width='2'/></g></svg>");
    for (const double factor : {1.0, 2.0})
        for (const std::string option : {"--avoid", "--near"}) {
            const Words asked{option,     map + "#roads:stroke",           "--radius", "1",
                              "--domain", factor == 1 ? "60x40" : "120x80"};
            ASSERT_EQ(sample_with(joined(asked, {"-o", csv})).exit_code, 0);
            EXPECT_EQ(verify_with(joined({csv}, asked)).exit_code, 0);
            for (const Point& point : files::read_points(csv)) {
                const bool is_on_road =
                    std::abs(point.x / factor - 30) < 4 || std::abs(point.y / factor - 35) < 1;
                EXPECT_EQ(is_on_road, option == "--near") << point.x << " " << point.y;
            }
        }
    const auto refusal = [&](const Words& options) {
        return sample_with(joined(options, {"--radius", "1", "-o", csv})).err;
    };
    EXPECT_EQ(refusal({"--avoid", map + ":stroke", "--domain", "60x50"}),
              "lacuna: --avoid " + map +
                  ":stroke: the domain must have the shape of the page, or strokes are not "
                  "equally wide everywhere\n");
    EXPECT_EQ(refusal({"--near", "a.txt:stroke"}),
              "lacuna: --near a.txt:stroke: must be an .svg, which says how wide its strokes "
              "are\n");
    write_file(map, "<svg viewBox='0 0 60 40'><circle cx='10' cy='30' r='5'/></svg>");
    EXPECT_EQ(
        refusal({"--avoid", map + ":stroke"}),
        "lacuna: " + map + ": no line with a stroke: there must be one, or give FILE:WIDTH\n");
}

}  // namespace placement_test
