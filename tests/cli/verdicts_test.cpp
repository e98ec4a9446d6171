// What `lacuna verify` says of sets on fields, in places, of classes and beside others: a table of
// points, claims and words. That sets are proven at all is in made_with_test.cpp.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/pictures.h"
#include "expectations.h"
#include "program.h"

namespace verdicts_test {

using namespace lacuna::tests;

struct Verdict {
    std::string points;
    Words claim;
    int exit_code;
    Words says;
};

class Verdicts : public testing::Test {
protected:
    std::string file(const char* name, const std::string& content) const {
        write_file(folder_.path(name), content);
        return folder_.path(name);
    }
    Outcome verdict_of(const std::string& points, const Words& claim) const {
        const bool is_csv = points.starts_with("x,");
        return run(joined({"verify", file(is_csv ? "a.csv" : "a.txt", points)}, claim));
    }
    void expect(const std::vector<Verdict>& rows) const {
        for (const auto& [points, claim, exit_code, says] : rows) {
            SCOPED_TRACE(testing::PrintToString(claim) + " of\n" + points);
            const Outcome outcome = verdict_of(points, claim);
            EXPECT_EQ(outcome.exit_code, exit_code);
            expect_has(outcome.out + outcome.err, says);
            EXPECT_EQ(outcome.out.find(" inf"), std::string::npos) << outcome.out;
        }
    }

    const Folder folder_;
    const std::string field_ = file("field.pgm", pgm(2, 1, bytes({0, 0xc0})));
    const std::string half_ = file("half.pgm", pgm(2, 1, bytes({0, 0xff})));
    const std::string ring_ = file("ring.txt", "0.5 0\n1 0\n1 0.5\n0.5 0.5\n");
};

TEST_F(Verdicts, OfFewPoints) {
    const std::string two = "0.1 0.1\n0.9 0.9\n", outside = "x,y\n0.5,0.5\n1.5,0.5\n";
    expect({{two,
             {"--radius", "0.1", "--distances-only"},
             0,
             {"a Poisson-disk set of radius 0.1", "was not asked"}},
            {two, {"--radius", "1.2", "--distances-only"}, 1, {}},
            {outside, {"--radius", "2"}, 1, {"point 1 at (1.5, 0.5)", "[0, 1] x [0, 1]"}},
            {outside, {"--radius", "0.9", "--domain", "2x1", "--torus"}, 0, {}},
            {"# nothing\n",
             {"--radius", "5"},
             1,
             {"for want of two points", "for want of a point", "not covered"}},
            {"0.5 0.5\n", {"--radius", "0.8"}, 0, {"for want of two points", "0.70710678"}}});
}

// The importance is 1 and 63/255, so that the radii are 0.3 and 0.6036 at scale 0.3.
TEST_F(Verdicts, OnAField) {
    const std::string two = "0.25 0.25\n0.75 0.25\n";
    const auto at = [&](const std::string& scale) {
        return Words{"--field", field_, "--scale", scale};
    };
    expect({{two,
             at("0.36"),
             0,
             {" 1 x 0.5, box", " 0.36 to 0.724", "at scale 0.36", "field.pgm",
              " 7.450580596923828e-09", " 0.5 of 0.36 (points 0 and 1)", "none over its limit",
              "a maximal Poisson-disk set that follows the field at scale 0.36, to a tolerance"}},
            {two,
             at("0.3"),
             1,
             {" 0.353553", " of 0.3, at (", "not covered",
              "not maximal: there is room for a point at ("}},
            {two,
             at("0.51"),
             1,
             {"points 0 at (0.25, 0.25) and 1 at (0.75, 0.25) are closer than 0.51"}},
            {two,
             {"--field", half_, "--scale", "0.1"},
             1,
             {"refused: point 1 at (0.75, 0.25) lies where the field has no"}},
            // Turned around, and stretched over another domain.
            {"3 2\n", {"--field", half_, "--scale", "3", "--invert", "--domain", "4x4"}, 0, {}}});
    const auto set = nlohmann::json::parse(
        verdict_of(two, {"--field", half_, "--scale", "0.1", "--json"}).out)["sets"][0];
    EXPECT_EQ(set["forbidden"]["point"], 1);
    EXPECT_EQ(set["forbidden"]["by"], "field");
    EXPECT_EQ(set["scale"], 0.1);
}

TEST_F(Verdicts, InPlaces) {
    const std::string left = "0.25 0.25\n", right = "0.75 0.25\n";
    const std::string maximal = "a maximal Poisson-disk set of radius 0.4 where points may lie";
    const std::string kept = file("kept.txt", right),
                      rocks = file("rocks.csv", "x,y,radius\n0.3,0.3,0.1\n");
    const std::string lake = file("lake.txt", "-1 -1\n2 -1\n2 2\n-1 2\n");
    const auto of = [](const std::string& radius, const Words& more) {
        return joined({"--domain", "1x0.5", "--radius", radius}, more);
    };
    expect(
        {{right, of("0.4", {"--mask", half_}), 0, {maximal}},
         {left,
          of("0.4", {"--mask", half_}),
          1,
          {"refused: point 0 at (0.25, 0.25) lies where the mask lets none lie"}},
         {right, of("0.4", {"--inside", ring_}), 0, {maximal}},
         {left, of("0.4", {"--inside", ring_, "--edge", "0.01"}), 1, {"lies outside the polygons"}},
         {"0.31 0.3\n", of("1", {"--avoid", rocks}), 1, {"where the polygons let none lie"}},
         {"0.5 0.05\n",
          of("0.4", {"--border", "0.1"}),
          1,
          {"lies nearer than 0.1 to an edge of the domain"}},
         {left,
          of("0.8", {"--keep", kept}),
          1,
          {"refused: the set does not have point 0 of ", "kept.txt, at (0.75, 0.25)"}},
         {right, of("0.8", {"--keep", kept}), 0, {"maximal"}},
         {"", of("0.4", {"--outside", lake}), 0, {"none, since points may lie nowhere"}}});
}

TEST_F(Verdicts, OfClasses) {
    const std::string one = "x,y,class\n0.5,0.5,grass\n", two = one + "0.6,0.5,trees\n";
    const std::string pond = file("pond.txt", "0.1 0.1\n0.3 0.1\n0.3 0.3\n");
    const Words wood{"--class", "trees:0.45", "--class", "grass:0.4"};
    const auto of = [&](const Words& more) { return joined(wood, more); };
    expect({{one, wood, 0, {"a maximal Poisson-disk set of 2 classes"}},
            {two, wood, 1, {"of class trees, are closer than 0.85"}},
            {one,
             {"--class", "trees:0.45", "--class", "grass:0.05"},
             1,
             {"there is room for a point of class grass at "}},
            {one,
             {"--class", "trees:0.45", "--class", "grass:0.4:1:2"},
             1,
             {"refused: class grass has 1 points in place of 2"}},
            {one,
             {"--class", "trees:0.45", "--class", "grass:0.4:1:1"},
             0,
             {"of 2 classes with their numbers"}},
            {"x,y,class\n0.1,0.5,grass\n",
             of({"--border", "trees:0.3", "--border", "grass:0.2"}),
             1,
             {", of class grass, lies nearer than 0.2 to an edge of the domain"}},
            {one, of({"--inside", "grass:" + pond}), 1, {", of class grass, lies outside"}},
            {one, of({"--inside-by-radius"}), 0, {"border            0.45 of trees, 0.4 of grass"}},
            {one,
             of({"--mask", "trees:" + half_, "--mask", "trees:" + field_}),
             2,
             {"--mask trees:" + field_ + ": a second mask of class trees\n"}}});
    const auto found = nlohmann::json::parse(
        verdict_of(one, {"--class", "trees:0.45", "--class", "grass:0.4:1:2", "--json"}).out);
    EXPECT_EQ(found["sets"][0]["miscounted"], "grass");
    // A .json names its classes, which other files may not have.
    const std::string json = folder_.path("a.json"), other = folder_.path("b.json");
    expect_success(joined({"sample", "--quiet", "-o", json}, wood));
    expect_success({"sample", "--quiet", "-o", other, "--class", "a:0.3"});
    expect_one_error(run({"verify", json, other, "--inside", "grass:" + pond}), 2,
                     {"--inside grass: is no class of this set\n"});
}

TEST_F(Verdicts, BesideOthers) {
    const std::string west = file("west.csv", "x,y\n-3,0.5\n0.96,0.5\n");
    const std::string kinds = file("kinds.csv", "x,y,class\n0.999,0.5,trees\n");
    const Words east{"--domain", "1,0+1x1"},
        close = joined(east, {"--radius", "0.1", "--keep", west});
    const std::string point = "x,y\n1.01,0.5\n";
    expect({{point,
             close,
             1,
             {"points 0 at (1.01, 0.5) and 1 of " + west + " at (0.96, 0.5) are closer than 0.1",
              "2 of them outside of the domain"}},
            {"x,y,class\n1.01,0.5,grass\n",
             joined(east, {"--class", "trees:2", "--class", "grass:1", "--keep", kinds}),
             1,
             {"0 of " + kinds + " at (0.999, 0.5), of class trees, are closer"}}});
    const auto set =
        nlohmann::json::parse(verdict_of(point, joined(close, {"--json"})).out)["sets"][0];
    EXPECT_EQ(set["closest_pair"]["points"], nlohmann::json({0, 2}));
    EXPECT_EQ(set["neighbours"], 1);
}

}  // namespace verdicts_test
