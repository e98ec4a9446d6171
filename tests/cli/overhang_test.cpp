// Places of classes: borders and polygons of their own, and objects that overhang nothing.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "expectations.h"
#include "files/read_sets.h"
#include "files/read_whole.h"
#include "judge/plane.h"
#include "program.h"

namespace overhang_test {

using namespace lacuna;
using namespace lacuna::tests;
Outcome run(const std::string& command, const Words& arguments) {
    return tests::run(joined({command}, arguments));
}

std::string made(const Words& arguments) {
    const Outcome outcome = run("sample", joined(arguments, {"--format", "csv", "--quiet"}));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_GT(outcome.out.size(), 100U);
    return outcome.out;
}

// A parcel with a yard in it.
const std::vector<PolygonRing> kParcel{{{12, 3}, {88, 14}, {95, 60}, {60, 92}, {20, 70}, {3, 40}},
                                       {{40, 30}, {60, 35}, {50, 55}}};

std::string text_of_parcel() {
    std::string text;
    for (const PolygonRing& ring : kParcel) {
        for (const Point& at : ring)
            text += std::to_string(at.x) + " " + std::to_string(at.y) + "\n";
        text += "\n";
    }
    return text;
}

const std::vector<double> kRadii{8, 3, 0.8};
const Words kKinds{"--class", "big:8:50", "--class", "mid:3:2", "--class", "small:0.8"};

TEST(Objects, OverhangNoOutlineByTheirRadius) {
    const Folder folder;
    const std::string parcel = folder.path("parcel.txt"), json = folder.path("a.json");
    write_file(parcel, text_of_parcel());
    ASSERT_EQ(run("sample",
                  joined(kKinds, {"--inside", parcel, "--inside-by-radius", "-o", json, "--quiet"}))
                  .exit_code,
              0);
    const files::SetsOfFile file = files::read_sets(json);
    const std::vector<Point>& points = file.sets.front();
    std::vector<double> least(3, std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t kind = file.classes.of_point[i];
        least[kind] = std::min(least[kind], judge::depth_in(kParcel, points[i]) - kRadii[kind]);
    }
    for (std::size_t kind = 0; kind < 3; ++kind) {
        EXPECT_GE(least[kind], 0) << kind;
        EXPECT_LT(least[kind], kRadii[kind] / 2) << kind;  // so classes reach to their borders
    }
    const Outcome proven = run("verify", {json, "--inside", parcel});
    EXPECT_EQ(proven.exit_code, 0) << proven.out << proven.err;
    expect_has(proven.out, {"border            8 of big, 3 of mid, 0.8 of small"});

    // An object a little nearer to the yard than its radius.
    nlohmann::json moved = nlohmann::json::parse(files::read_whole(json));
    const auto small = std::find(file.classes.of_point.begin(), file.classes.of_point.end(), 2);
    const auto index = static_cast<std::size_t>(small - file.classes.of_point.begin());
    moved["points"][index] = {50.0, 55.79};
    write_file(json, moved.dump());
    const Outcome refuted = run("verify", {json, "--inside", parcel});
    EXPECT_EQ(refuted.exit_code, 1);
    expect_has(refuted.out, {"refused: point " + std::to_string(index) + " at"});
}

TEST(Objects, HaveTheirRadiusAsTheirBorder) {
    const Folder folder;
    const std::string parcel = folder.path("parcel.txt"), rock = folder.path("rock.csv");
    write_file(parcel, text_of_parcel());
    write_file(rock, "x,y\n30,30\n");
    const Words inside = joined(kKinds, {"--inside", parcel});
    EXPECT_EQ(made(joined(inside, {"--inside-by-radius"})),
              made(joined(inside, {"--border", "mid:3", "--border", "0.8", "--border", "big:8"})));
    // Without classes half of the distance that two points keep, from obstacles too.
    EXPECT_EQ(
        made({"--inside", parcel, "--avoid", rock + ":2", "--radius", "3", "--inside-by-radius"}),
        made({"--inside", parcel, "--avoid", rock + ":3.5", "--radius", "3", "--border", "1.5"}));
    // By union two of a class keep its radius, so that objects are half as large.
    const Words by_union{"--class",  "a:0.2", "--class",   "b:0.05",
                         "--domain", "1x1",   "--between", "union"};
    EXPECT_EQ(made(joined(by_union, {"--inside-by-radius"})),
              made(joined(by_union, {"--border", "a:0.1", "--border", "b:0.025"})));
}

TEST(PolygonsOfClasses, AreNamedWhereTheyForbidAndReadByTheirClass) {
    const Folder folder;
    const std::string parcel = folder.path("parcel.txt"), json = folder.path("a.json");
    const std::string wet = folder.path("wet.txt"), road = folder.path("b:road.txt");
    write_file(parcel, "0 0\n1 0\n1 1\n0 1\n");
    write_file(wet, "0.2 0.2\n0.7 0.2\n0.7 0.5\n0.2 0.5\n");
    write_file(road, "0.4 0\n0.6 0\n0.6 1\n0.4 1\n");
    const Words kinds{"--class", "trees:0.05", "--class", "reeds:0.02:50", "--class", "grass:0.01"};
    const Words where{"--inside", parcel, "--inside", "reeds:" + wet, "--outside", "trees:" + road};
    ASSERT_EQ(run("sample", joined(joined(kinds, where), {"-o", json, "--quiet"})).exit_code, 0);
    const Outcome elsewhere = run("verify", {json, "--inside", parcel, "--outside", "trees:" + road,
                                             "--inside", "grass:" + wet});
    EXPECT_EQ(elsewhere.exit_code, 1);
    expect_has(elsewhere.out, {", of class grass, lies"});
    const std::string other = folder.path("other.json");
    ASSERT_EQ(run("sample", {"--class", "a:0.3", "-o", other, "--quiet"}).exit_code, 0);
    EXPECT_EQ(
        run("verify", {json, other, "--inside", "reeds:" + wet, "--outside", "trees:" + road}).err,
        "lacuna: --inside reeds: is no class of this set\n");
    // A name before the colon that is no class belongs to the path.
    const Outcome missing =
        run("sample", joined(kinds, {"--inside", "rocks:a.txt", "--format", "csv"}));
    expect_has(missing.err, {"rocks:a.txt: "});
    EXPECT_EQ(run("sample", joined(kinds, {"--outside", road, "-o", json, "--quiet"})).exit_code,
              0);
    const Outcome overwritten = run(
        "sample", joined(kinds, {"--inside", "reeds:" + wet, "-o", wet + ".csv", "--report", wet}));
    EXPECT_NE(overwritten.exit_code, 0);
    EXPECT_EQ(files::read_whole(wet).substr(0, 7), "0.2 0.2");
}

TEST(BordersOfClasses, AreNamedWhenAPointIsNearer) {
    const Folder folder;
    const std::string csv = folder.path("a.csv");
    const Words kinds{"--class", "a:0.1", "--class", "b:0.03"};
    const Words both{"--border", "a:0.25", "--border", "b:0.2"};
    write_file(csv, made(joined(kinds, both)));
    EXPECT_EQ(run("verify", joined(joined({csv}, kinds), both)).exit_code, 0);
    const Outcome less = run("verify", joined(joined({csv}, kinds), {"--border", "a:0.25"}));
    EXPECT_EQ(less.exit_code, 1);
    EXPECT_NE(less.out.find("there is room for a point of class b at"), std::string::npos)
        << less.out;
    const Outcome more = run("verify", joined(joined({csv}, kinds), {"--border", "b:0.3"}));
    EXPECT_EQ(more.exit_code, 1);
    EXPECT_NE(more.out.find(", of class b, lies nearer than 0.3 to an edge of the domain"),
              std::string::npos)
        << more.out;
}

TEST(BordersOfClasses, AreRefusedInOneLine) {
    const auto refusal = [](const Words& arguments) {
        const Outcome outcome = run("sample", joined(arguments, {"--format", "csv"}));
        EXPECT_NE(outcome.exit_code, 0);
        return outcome.err;
    };
    const Words kinds{"--class", "a:0.1", "--class", "b:0.03"};
    EXPECT_EQ(refusal(joined(kinds, {"--border", "c:1"})),
              "lacuna: --border c:1: must be D, or NAME:D with the name of a class (a or b)\n");
    EXPECT_EQ(refusal(joined(kinds, {"--border", "a:wide"})),
              "lacuna: --border a:wide: D must be a number, such as 0.01 or 1e-2\n");
    EXPECT_EQ(refusal(joined(kinds, {"--border", "a:"})),
              "lacuna: --border a:: D must be a number, such as 0.01 or 1e-2\n");
    EXPECT_EQ(refusal(joined(kinds, {"--border", "a:0.1", "--border", "a:0.2"})),
              "lacuna: --border a:0.2: is given twice\n");
    EXPECT_EQ(refusal(joined(kinds, {"--border", "0.1", "--border", "0.2"})),
              "lacuna: --border 0.2: is given twice\n");
    EXPECT_EQ(refusal(joined(kinds, {"--border", "a:0.6"})),
              "lacuna: --border a:0.6: must be at least 0 and under half of the domain's shorter "
              "side, 0.5\n");
    const std::string by_radius = "lacuna: --inside-by-radius with --";
    EXPECT_EQ(refusal(joined(kinds, {"--inside-by-radius", "--border", "0.1"})),
              by_radius + "border: both say how far to stay\n");
    EXPECT_EQ(refusal({"--inside-by-radius", "--count", "9"}),
              by_radius + "count: the radius must be known before: give it\n");
    EXPECT_EQ(refusal({"--inside-by-radius", "--radius", "0.1", "--torus"}),
              by_radius + "torus: a torus has no edges\n");
}

TEST(Objects, ThatHaveNoPlaceAreNamed) {
    const Folder folder;
    const auto refusal = [](const Words& arguments) {
        const Outcome outcome =
            run("sample", joined(arguments, {"--inside-by-radius", "--format", "csv"}));
        EXPECT_EQ(outcome.exit_code, 2);
        return outcome.err;
    };
    const std::string half =
        "must be under half of the domain's shorter side, 0.5, or there is no "
        "place for them\n";
    EXPECT_EQ(refusal({"--class", "a:0.6", "--class", "b:0.02"}),
              "lacuna: --inside-by-radius with objects of class a: their radius is 0.6: " + half);
    EXPECT_EQ(refusal({"--radius", "1.2"}),
              "lacuna: --inside-by-radius with objects: their radius is 0.6: " + half);
    EXPECT_EQ(refusal({"--radius", "nan"}),
              "lacuna: --radius nan: must be a finite number greater than 0\n");
    const std::string strip = folder.path("strip.txt");
    write_file(strip, "0.4 0.1\n0.45 0.1\n0.45 0.9\n0.4 0.9\n");
    const Words in_strip{"--class", "a:0.1", "--class", "b:0.01", "--domain", "1x1", "--inside"};
    const Outcome narrow = run(
        "sample", joined(in_strip, {strip, "--inside-by-radius", "-o", folder.path("narrow.csv")}));
    expect_has(narrow.err, {"(the domain, [0, 1) x [0, 1), has no open place for a wider than "
                            "twice the --edge)"});
    EXPECT_EQ(
        refusal(joined(in_strip, {"c:" + strip})),
        "lacuna: --inside c:" + strip + ": there is no such file, and c is not a class (a or b)\n");
    EXPECT_EQ(refusal(joined(in_strip, {"a:"})),
              "lacuna: --inside a:: must be NAME:FILE, with a file\n");
}

}  // namespace overhang_test
