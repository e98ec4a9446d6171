// Given a field, a mask, polygons, a border or points to keep, `lacuna verify` says what holds.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "expectations.h"
#include "program.h"

namespace {

using namespace lacuna::tests;

// Two pixels, of these luminances; the domain is 1 x 0.5.
std::string picture(char left, char right) {
    return std::string("P5\n2 1\n255\n") + left + right;
}

TEST(VerifyAField, TellsThePairAndTheSpotInTermsOfTheirLimits) {
    const Folder folder;
    const std::string field = folder.path("field.pgm");
    const std::string points = folder.path("points.txt");
    write_file(field, picture(0, '\xc0'));  // importance 1 and 63/255: radii 0.3 and 0.6036
    write_file(points, "0.25 0.25\n0.75 0.25\n");
    const Outcome whole = run({"verify", points, "--field", field, "--scale", "0.36"});
    EXPECT_EQ(whole.exit_code, 0) << whole.out << whole.err;
    expect_has(line_of(whole.out, "domain"), {" 1 x 0.5, box"});
    expect_has(line_of(whole.out, "radius"), {" 0.36 to 0.724", "at scale 0.36"});
    expect_has(line_of(whole.out, "field"), {"field.pgm"});
    expect_has(line_of(whole.out, "tolerance"), {" 7.450580596923828e-09"});
    expect_has(line_of(whole.out, "least distance"), {" 0.5 of 0.36 (points 0 and 1)", "kept"});
    expect_has(line_of(whole.out, "largest gap"), {" none over its limit", "covered"});
    expect_has(line_of(whole.out, "verdict"),
               {"a maximal Poisson-disk set that follows the field at scale 0.36, to a tolerance"});

    const Outcome bare = run({"verify", points, "--field", field, "--scale", "0.3"});
    EXPECT_EQ(bare.exit_code, 1);
    expect_has(line_of(bare.out, "largest gap"), {" 0.353553", " of 0.3, at (", "not covered"});
    expect_has(line_of(bare.out, "verdict"), {"not maximal: there is room for a point at ("});

    const Outcome close = run({"verify", points, "--field", field, "--scale", "0.51"});
    EXPECT_EQ(close.exit_code, 1);
    expect_has(line_of(close.out, "verdict"),
               {"points 0 at (0.25, 0.25) and 1 at (0.75, 0.25) are closer than 0.51"});
}

TEST(VerifyAField, RefusesAPointWhereThereIsNoImportance) {
    const Folder folder;
    const std::string field = folder.path("field.pgm");
    write_file(field, picture(0, '\xff'));
    write_file(folder.path("a.txt"), "0.25 0.25\n0.75 0.25\n");
    const Outcome outcome =
        run({"verify", folder.path("a.txt"), "--field", field, "--scale", "0.1", "--json"});
    EXPECT_EQ(outcome.exit_code, 1);
    const auto set = nlohmann::json::parse(outcome.out)["sets"][0];
    EXPECT_EQ(set["forbidden"]["point"], 1);
    EXPECT_EQ(set["forbidden"]["by"], "field");
    EXPECT_EQ(set["scale"], 0.1);
    expect_has(set["verdict"], {"refused: point 1 at (0.75, 0.25) lies where the field has no"});
    // Turned around, and stretched over another domain.
    write_file(folder.path("b.txt"), "3 2\n");
    expect_success({"verify", folder.path("b.txt"), "--field", field, "--scale", "3", "--invert",
                    "--domain", "4x4", "--quiet"});
}

TEST(VerifyPlaces, OfAMaskPolygonsABorderAndKeptPoints) {
    const Folder folder;
    write_file(folder.path("mask.pgm"), picture(0, '\xff'));
    write_file(folder.path("ring.txt"), "0.5 0\n1 0\n1 0.5\n0.5 0.5\n");
    write_file(folder.path("right.txt"), "0.75 0.25\n");
    write_file(folder.path("left.txt"), "0.25 0.25\n");
    write_file(folder.path("edge.txt"), "0.5 0.05\n");
    const auto verdict_of = [&](const std::string& file, std::vector<std::string> options,
                                int exit_code) {
        options.insert(options.begin(), {"verify", folder.path(file), "--domain", "1x0.5"});
        const Outcome outcome = run(options);
        EXPECT_EQ(outcome.exit_code, exit_code) << outcome.out << outcome.err;
        return line_of(outcome.out, "verdict");
    };
    const std::string maximal = "a maximal Poisson-disk set of radius 0.4 where points may lie";
    const std::string radius = "0.4";
    const std::string mask = folder.path("mask.pgm");
    const std::string ring = folder.path("ring.txt");
    const std::string right = folder.path("right.txt");
    expect_has(verdict_of("right.txt", {"--radius", radius, "--mask", mask}, 0), {maximal});
    expect_has(verdict_of("left.txt", {"--radius", radius, "--mask", mask}, 1),
               {"refused: point 0 at (0.25, 0.25) lies where the mask lets none lie"});
    expect_has(verdict_of("right.txt", {"--radius", radius, "--inside", ring}, 0), {maximal});
    expect_has(verdict_of("left.txt", {"--radius", radius, "--inside", ring, "--edge", "0.01"}, 1),
               {"lies outside the polygons"});
    expect_has(verdict_of("edge.txt", {"--radius", radius, "--border", "0.1"}, 1),
               {"lies nearer than 0.1 to an edge of the domain"});
    expect_has(verdict_of("left.txt", {"--radius", "0.8", "--keep", right}, 1),
               {"refused: the set does not have point 0 of ", "right.txt, at (0.75, 0.25)"});
    expect_has(verdict_of("right.txt", {"--radius", "0.8", "--keep", right}, 0), {"maximal"});
}

}  // namespace
