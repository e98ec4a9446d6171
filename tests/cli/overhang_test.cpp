// Places of classes: borders and polygons of their own, and objects that overhang nothing.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "files/read_sets.h"
#include "files/read_whole.h"
#include "program.h"

namespace overhang_test {

using namespace lacuna;
using namespace lacuna::tests;
using Names = std::vector<std::string>;

Names with(Names first, const Names& more) {
    first.insert(first.end(), more.begin(), more.end());
    return first;
}

Outcome run(const std::string& command, const Names& arguments) {
    return tests::run(with({command}, arguments));
}

std::string made(const Names& arguments) {
    const Outcome outcome = run("sample", with(arguments, {"--format", "csv", "--quiet"}));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_GT(outcome.out.size(), 100U);
    return outcome.out;
}

// A parcel with a yard in it.
const std::vector<std::vector<Point>> kParcel{
    {{12, 3}, {88, 14}, {95, 60}, {60, 92}, {20, 70}, {3, 40}}, {{40, 30}, {60, 35}, {50, 55}}};

std::string text_of_parcel() {
    std::string text;
    for (const std::vector<Point>& ring : kParcel) {
        for (const Point& at : ring)
            text += std::to_string(at.x) + " " + std::to_string(at.y) + "\n";
        text += "\n";
    }
    return text;
}

Point nearest_on(Point at, Point from, Point to) {
    const double dx = to.x - from.x, dy = to.y - from.y;
    const double along = ((at.x - from.x) * dx + (at.y - from.y) * dy) / (dx * dx + dy * dy);
    const double share = std::clamp(along, 0.0, 1.0);
    return {from.x + share * dx, from.y + share * dy};
}

// The place of the parcel's outlines that is nearest to a point.
Point nearest_outline(Point at) {
    Point nearest{0, 0};
    double least = std::numeric_limits<double>::infinity();
    for (const std::vector<Point>& ring : kParcel)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point there = nearest_on(at, ring[i], ring[(i + 1) % ring.size()]);
            const double distance = std::hypot(there.x - at.x, there.y - at.y);
            if (distance < least) nearest = there;
            least = std::min(least, distance);
        }
    return nearest;
}

const std::vector<double> kRadii{8, 3, 0.8};
const Names kKinds{"--class", "big:8:50", "--class", "mid:3:2", "--class", "small:0.8"};

TEST(Objects, OverhangNoOutlineByTheirRadius) {
    const Folder folder;
    const std::string parcel = folder.path("parcel.txt"), json = folder.path("a.json");
    write_file(parcel, text_of_parcel());
    const Names where{"--inside", parcel, "--inside-by-radius"};
    ASSERT_EQ(run("sample", with(with(kKinds, where), {"-o", json, "--quiet"})).exit_code, 0);
    const files::SetsOfFile file = files::read_sets(json);
    const std::vector<Point>& points = file.sets.front();
    std::vector<double> least(3, std::numeric_limits<double>::infinity());
    std::size_t tightest = 0;
    double least_of_all = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point outline = nearest_outline(points[i]);
        const std::size_t kind = file.classes.of_point[i];
        const double over =
            std::hypot(outline.x - points[i].x, outline.y - points[i].y) - kRadii[kind];
        least[kind] = std::min(least[kind], over);
        if (over < least_of_all) tightest = i;
        least_of_all = std::min(least_of_all, over);
    }
    for (std::size_t kind = 0; kind < 3; ++kind) {
        EXPECT_GE(least[kind], 0) << kind;
        EXPECT_LT(least[kind], kRadii[kind] / 2) << kind;  // so classes reach to their borders
    }
    // The file says how it was made; a .csv needs the options.
    const Outcome proven = run("verify", {json, "--inside", parcel});
    EXPECT_EQ(proven.exit_code, 0) << proven.out << proven.err;
    EXPECT_NE(proven.out.find("border            8 of big, 3 of mid, 0.8 of small"),
              std::string::npos)
        << proven.out;
    const std::string csv = folder.path("a.csv");
    write_file(csv, made(with(kKinds, where)));
    EXPECT_EQ(run("verify", with(with({csv}, kKinds), where)).exit_code, 0);
    EXPECT_EQ(run("verify", with(with({csv}, kKinds), {"--inside", parcel})).exit_code, 1);

    // The object that is nearest to an outline, moved a thousandth of a unit across its border.
    nlohmann::json moved = nlohmann::json::parse(files::read_whole(json));
    const Point at = points[tightest], outline = nearest_outline(at);
    const double share = (least_of_all + 1e-3) / std::hypot(outline.x - at.x, outline.y - at.y);
    moved["points"][tightest] = {at.x + share * (outline.x - at.x),
                                 at.y + share * (outline.y - at.y)};
    write_file(json, moved.dump());
    const Outcome refuted = run("verify", {json, "--inside", parcel});
    EXPECT_EQ(refuted.exit_code, 1);
    EXPECT_NE(refuted.out.find("refused: point " + std::to_string(tightest) + " at"),
              std::string::npos)
        << refuted.out;
}

TEST(Objects, HaveTheirRadiusAsTheirBorder) {
    const Folder folder;
    const std::string parcel = folder.path("parcel.txt"), rock = folder.path("rock.csv");
    write_file(parcel, text_of_parcel());
    write_file(rock, "x,y\n30,30\n");
    const Names inside = with(kKinds, {"--inside", parcel});
    EXPECT_EQ(made(with(inside, {"--inside-by-radius"})),
              made(with(inside, {"--border", "mid:3", "--border", "0.8", "--border", "big:8"})));
    // Without classes half of the distance that two points keep, from obstacles too.
    EXPECT_EQ(
        made({"--inside", parcel, "--avoid", rock + ":2", "--radius", "3", "--inside-by-radius"}),
        made({"--inside", parcel, "--avoid", rock + ":3.5", "--radius", "3", "--border", "1.5"}));
    // By union two of a class keep its radius, so that objects are half as large.
    const Names by_union{"--class",  "a:0.2", "--class",   "b:0.05",
                         "--domain", "1x1",   "--between", "union"};
    EXPECT_EQ(made(with(by_union, {"--inside-by-radius"})),
              made(with(by_union, {"--border", "a:0.1", "--border", "b:0.025"})));
}

TEST(Objects, KeepAwayFromObstaclesByTheirRadius) {
    const Folder folder;
    const std::string rock = folder.path("rock.csv"), json = folder.path("a.json");
    write_file(rock, "x,y,radius\n0.5,0.5,0.1\n");
    const Names kinds{"--class", "a:0.1", "--class", "b:0.02"};
    ASSERT_EQ(
        run("sample", with(kinds, {"--avoid", rock, "--inside-by-radius", "-o", json, "--quiet"}))
            .exit_code,
        0);
    const files::SetsOfFile file = files::read_sets(json);
    for (std::size_t i = 0; i < file.sets.front().size(); ++i) {
        const Point at = file.sets.front()[i];
        const double radius = file.classes.of_point[i] == 0 ? 0.1 : 0.02;
        EXPECT_GE(std::hypot(at.x - 0.5, at.y - 0.5), 0.1 + radius);
        EXPECT_GE(std::min({at.x, at.y, 1 - at.x, 1 - at.y}), radius);
    }
    const Outcome proven = run("verify", {json, "--avoid", rock});
    EXPECT_EQ(proven.exit_code, 0) << proven.out;
}

TEST(PolygonsOfClasses, HoldTheirPointsAlone) {
    const Folder folder;
    const std::string parcel = folder.path("parcel.txt"), json = folder.path("a.json");
    const std::string wet = folder.path("wet.txt"), road = folder.path("b:road.txt");
    write_file(parcel, "0 0\n1 0\n1 1\n0 1\n");
    write_file(wet, "0.2 0.2\n0.7 0.2\n0.7 0.5\n0.2 0.5\n");
    write_file(road, "0.4 0\n0.6 0\n0.6 1\n0.4 1\n");
    const Names kinds{"--class", "trees:0.05", "--class", "reeds:0.02:50", "--class", "grass:0.01"};
    const Names where{"--inside", parcel, "--inside", "reeds:" + wet, "--outside", "trees:" + road};
    ASSERT_EQ(run("sample", with(with(kinds, where), {"-o", json, "--quiet"})).exit_code, 0);
    const files::SetsOfFile file = files::read_sets(json);
    std::vector<std::size_t> counts(3), in_wet(3), on_road(3);
    for (std::size_t i = 0; i < file.sets.front().size(); ++i) {
        const Point at = file.sets.front()[i];
        const std::size_t kind = file.classes.of_point[i];
        ++counts[kind];
        in_wet[kind] += at.x >= 0.2 && at.x <= 0.7 && at.y >= 0.2 && at.y <= 0.5;
        on_road[kind] += at.x > 0.4 && at.x < 0.6;
    }
    EXPECT_GT(counts[1], 20U);
    EXPECT_EQ(in_wet[1], counts[1]);
    EXPECT_GT(counts[0], 20U);
    EXPECT_EQ(on_road[0], 0U);
    EXPECT_GT(on_road[1], 0U);
    EXPECT_GT(on_road[2], 100U);
    EXPECT_LT(in_wet[2], counts[2]);
    const Outcome proven = run("verify", with({json}, where));
    EXPECT_EQ(proven.exit_code, 0) << proven.out << proven.err;

    const Names off_road{json, "--inside", parcel, "--outside", "trees:" + road};
    const Outcome elsewhere = run("verify", with(off_road, {"--inside", "grass:" + wet}));
    EXPECT_EQ(elsewhere.exit_code, 1);
    EXPECT_NE(elsewhere.out.find(", of class grass, lies"), std::string::npos) << elsewhere.out;
    const std::string other = folder.path("other.json");
    ASSERT_EQ(run("sample", {"--class", "a:0.3", "-o", other, "--quiet"}).exit_code, 0);
    EXPECT_EQ(
        run("verify", {json, other, "--inside", "reeds:" + wet, "--outside", "trees:" + road}).err,
        "lacuna: --inside reeds: is no class of this set\n");
    // A name before the colon that is no class belongs to the path.
    const Outcome missing =
        run("sample", with(kinds, {"--inside", "rocks:a.txt", "--format", "csv"}));
    EXPECT_NE(missing.err.find("rocks:a.txt: "), std::string::npos) << missing.err;
    EXPECT_EQ(run("sample", with(kinds, {"--outside", road, "-o", json, "--quiet"})).exit_code, 0);
    const Outcome overwritten = run(
        "sample", with(kinds, {"--inside", "reeds:" + wet, "-o", wet + ".csv", "--report", wet}));
    EXPECT_NE(overwritten.exit_code, 0);
    EXPECT_EQ(files::read_whole(wet).substr(0, 7), "0.2 0.2");
}

TEST(BordersOfClasses, AreNamedWhenAPointIsNearer) {
    const Folder folder;
    const std::string csv = folder.path("a.csv");
    const Names kinds{"--class", "a:0.1", "--class", "b:0.03"};
    const Names both{"--border", "a:0.25", "--border", "b:0.2"};
    write_file(csv, made(with(kinds, both)));
    EXPECT_EQ(run("verify", with(with({csv}, kinds), both)).exit_code, 0);
    const Outcome less = run("verify", with(with({csv}, kinds), {"--border", "a:0.25"}));
    EXPECT_EQ(less.exit_code, 1);
    EXPECT_NE(less.out.find("there is room for a point of class b at"), std::string::npos)
        << less.out;
    const Outcome more = run("verify", with(with({csv}, kinds), {"--border", "b:0.3"}));
    EXPECT_EQ(more.exit_code, 1);
    EXPECT_NE(more.out.find(", of class b, lies nearer than 0.3 to an edge of the domain"),
              std::string::npos)
        << more.out;
}

TEST(BordersOfClasses, AreRefusedInOneLine) {
    const auto refusal = [](const Names& arguments) {
        const Outcome outcome = run("sample", with(arguments, {"--format", "csv"}));
        EXPECT_NE(outcome.exit_code, 0);
        return outcome.err;
    };
    const Names kinds{"--class", "a:0.1", "--class", "b:0.03"};
    EXPECT_EQ(refusal(with(kinds, {"--border", "c:1"})),
              "lacuna: --border c:1: must be D, or NAME:D with the name of a class (a or b)\n");
    EXPECT_EQ(refusal(with(kinds, {"--border", "a:wide"})),
              "lacuna: --border a:wide: D must be a number, such as 0.01 or 1e-2\n");
    EXPECT_EQ(refusal(with(kinds, {"--border", "a:"})),
              "lacuna: --border a:: D must be a number, such as 0.01 or 1e-2\n");
    EXPECT_EQ(refusal(with(kinds, {"--border", "a:0.1", "--border", "a:0.2"})),
              "lacuna: --border a:0.2: is given twice\n");
    EXPECT_EQ(refusal(with(kinds, {"--border", "0.1", "--border", "0.2"})),
              "lacuna: --border 0.2: is given twice\n");
    EXPECT_EQ(refusal(with(kinds, {"--border", "a:0.6"})),
              "lacuna: --border a:0.6: must be at least 0 and under half of the domain's shorter "
              "side, 0.5\n");
    const std::string by_radius = "lacuna: --inside-by-radius with --";
    EXPECT_EQ(refusal(with(kinds, {"--inside-by-radius", "--border", "0.1"})),
              by_radius + "border: both say how far to stay\n");
    EXPECT_EQ(refusal({"--inside-by-radius", "--count", "9"}),
              by_radius + "count: the radius must be known before: give it\n");
    EXPECT_EQ(refusal({"--inside-by-radius", "--radius", "0.1", "--torus"}),
              by_radius + "torus: a torus has no edges\n");
}

TEST(Objects, ThatHaveNoPlaceAreNamed) {
    const Folder folder;
    const auto refusal = [](const Names& arguments) {
        const Outcome outcome =
            run("sample", with(arguments, {"--inside-by-radius", "--format", "csv"}));
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
    const Names in_strip{"--class", "a:0.1", "--class", "b:0.01", "--domain", "1x1", "--inside"};
    const Outcome narrow = run(
        "sample", with(in_strip, {strip, "--inside-by-radius", "-o", folder.path("narrow.csv")}));
    expect_has(narrow.err, {"(the domain, [0, 1) x [0, 1), has no open place for a wider than "
                            "twice the --edge)"});
    EXPECT_EQ(
        refusal(with(in_strip, {"c:" + strip})),
        "lacuna: --inside c:" + strip + ": there is no such file, and c is not a class (a or b)\n");
    EXPECT_EQ(refusal(with(in_strip, {"a:"})),
              "lacuna: --inside a:: must be NAME:FILE, with a file\n");
}

}  // namespace overhang_test
