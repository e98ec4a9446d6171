// Given point files, `lacuna analyze` reports their numbers in words and in files.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "expectations.h"
#include "program.h"

namespace {

using namespace lacuna::tests;
using Json = nlohmann::json;

// n x n points, 1 / n apart.
std::string lattice(int n, const std::string& between = " ") {
    std::ostringstream lines;
    lines.precision(17);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) lines << (i + 0.5) / n << between << (j + 0.5) / n << '\n';
    return lines.str();
}

TEST(Analyze, OfALatticeTellsItsKnownNumbers) {
    const Folder folder;
    write_file(folder.path("a.txt"), lattice(20));
    const Outcome outcome = run({"analyze", folder.path("a.txt"), "--torus", "--radius", "0.04"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
    expect_has(line_of(outcome.out, "sets"), {" 1"});
    expect_has(line_of(outcome.out, "points a set"), {" 400"});
    expect_has(line_of(outcome.out, "domain"), {" 1 x 1, torus"});
    expect_has(line_of(outcome.out, "count * radius^2 / area"), {" 0.64000"});
    expect_has(line_of(outcome.out, "least distance"), {" 0.05"});
    expect_has(line_of(outcome.out, "relative radius"), {" 0.9306"});  // sqrt(sqrt(3) / 2)
    expect_has(line_of(outcome.out, "mean nearest neighbour"), {" 0.05, 1.2500 radii"});
    expect_has(line_of(outcome.out, "radial power"), {" 0.000 "});
    expect_has(line_of(outcome.out, "effective Nyquist"), {" 1.0"});
}

TEST(Analyze, OfAStretchedLatticeTellsTheNumbersOfTheLattice) {
    const Folder folder;
    write_file(folder.path("a.txt"), lattice(20));
    std::ostringstream wide, tall;
    std::istringstream numbers(lattice(20));
    for (double x = 0, y = 0; numbers >> x >> y;) {
        wide << 2 * x << ' ' << y / 2 << '\n';
        tall << x / 2 << ' ' << 2 * y << '\n';
    }
    write_file(folder.path("wide.txt"), wide.str());
    write_file(folder.path("tall.txt"), tall.str());
    const std::string plain =
        run({"analyze", folder.path("a.txt"), "--torus", "--radius", "0.04"}).out;
    EXPECT_EQ(run({"analyze", folder.path("wide.txt"), "--torus", "--domain", "2x0.5", "--stretch",
                   "0.08:0.02@0"})
                  .out,
              plain);
    EXPECT_EQ(run({"analyze", folder.path("tall.txt"), "--torus", "--domain", "0.5x2", "--stretch",
                   "0.08:0.02@-90"})
                  .out,
              plain);
    EXPECT_EQ(run({"analyze", folder.path("a.txt"), "--stretch", "0.08:0.02@30"}).err,
              "lacuna: --stretch 0.08:0.02@30: the angle must be a multiple of 90 degrees: "
              "compressed along other axes, the domain would be no rectangle\n");
}

TEST(Analyze, WritesTheSameNumbersAsJsonWithTheirUnits) {
    const Folder folder;
    write_file(folder.path("a.txt"), lattice(20));
    const std::string report = folder.path("report.json");
    expect_success({"analyze", folder.path("a.txt"), "--torus", "--radius", "0.04", "-o", report});
    const Json json = Json::parse(content_of(report));
    EXPECT_EQ(json["files"], Json({folder.path("a.txt")}));
    EXPECT_EQ(json["sets"], 1);
    EXPECT_EQ(json["points_a_set"], Json({{"least", 400}, {"mean", 400.0}, {"most", 400}}));
    EXPECT_EQ(json["domain"]["boundary"], "torus");
    EXPECT_NEAR(json["count_times_squared_radius_over_area"], 0.64, 1e-12);
    const Json& nearest = json["nearest_neighbour"];
    EXPECT_NEAR(nearest["least_distance"], 0.05, 1e-12);
    EXPECT_NEAR(nearest["relative_radius"], std::sqrt(std::sqrt(3.0) / 2), 1e-9);
    double shares = nearest["histogram"]["share_beyond"];
    for (const double share : nearest["histogram"]["shares_of_points"]) shares += share;
    EXPECT_NEAR(shares, 1, 1e-12);
    EXPECT_EQ(json["pair_correlation"]["bin_width_over_mean_spacing"], 0.05);
    EXPECT_EQ(json["pair_correlation"]["g"].size(), 100U);
    const Json& radial = json["spectrum"]["radial"];
    EXPECT_EQ(radial["mean_power"].size(), radial["k_over_sqrt_count"].size());
    EXPECT_EQ(radial["anisotropy_db"][0], nullptr);
    EXPECT_NEAR(json["spectrum"]["peak"]["k_over_sqrt_count"], 1, 0.1);
    EXPECT_NEAR(json["spectrum"]["effective_nyquist_over_half_sqrt_count"], 1, 0.1);
    EXPECT_GT(json["spectrum"]["oscillations"], 2);
    EXPECT_EQ(json["bond_orientational_order"]["points"], 400);
}

TEST(Analyze, AveragesSeveralFiles) {
    const Folder folder;
    Words words{"analyze", "--torus"};
    for (int seed = 0; seed < 4; ++seed) {
        const std::string name = folder.path(std::to_string(seed) + ".txt");
        expect_success(
            {"sample", "--radius", "0.04", "--torus", "--seed", std::to_string(seed), "-o", name});
        words.push_back(name);
    }
    const Outcome from_files = run(words);
    EXPECT_EQ(from_files.exit_code, 0);
    expect_has(line_of(from_files.out, "sets"), {" 4"});
    expect_has(line_of(from_files.out, "points a set"), {" to ", "mean "});
    EXPECT_NE(run({"analyze", "--torus", folder.path("0.txt")}).out, from_files.out);
}

TEST(Analyze, TakesDomainAndRadiusFromAJsonFileUnlessTold) {
    const Folder folder;
    const std::string path = folder.path("a.json");
    expect_success({"sample", "--radius", "0.05", "--domain", "2x0.5", "-o", path});
    const Outcome outcome = run({"analyze", path});
    expect_has(line_of(outcome.out, "domain"), {" 2 x 0.5, box"});
    expect_has(line_of(outcome.out, "radius"), {" 0.05"});
    const Outcome told = run({"analyze", path, "--domain", "3x1", "--radius", "0.1"});
    expect_has(line_of(told.out, "domain"), {" 3 x 1, box"});
    expect_has(line_of(told.out, "radius"), {" 0.1"});
}

TEST(Analyze, ReadsStandardInput) {
    const Folder folder;
    write_file(folder.path("a.txt"), lattice(9));
    Setting shell;
    shell.program = "/bin/sh";
    const std::string analyze = "exec " LACUNA_PROGRAM " analyze - < ";
    const Outcome from_input = run({"-c", analyze + folder.path("a.txt")}, shell);
    EXPECT_EQ(from_input.out, run({"analyze", folder.path("a.txt")}).out);
}

TEST(Analyze, WritesSeveralReportsAtOnceAndTheSameBytesTwice) {
    const Folder folder;
    write_file(folder.path("a.txt"), lattice(9));
    const auto reports = [&](const std::string& stem) {
        Words words{"analyze", folder.path("a.txt")};
        for (const std::string extension : {".svg", ".pdf", ".png", ".json"}) {
            words.push_back("-o");
            words.push_back(folder.path(stem + extension));
        }
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_EQ(outcome.out, run({"analyze", folder.path("a.txt")}).out);
    };
    reports("one");
    reports("two");
    for (const std::string extension : {".svg", ".pdf", ".png", ".json"}) {
        const std::string one = content_of(folder.path("one" + extension));
        EXPECT_FALSE(one.empty()) << extension;
        EXPECT_EQ(one, content_of(folder.path("two" + extension))) << extension;
    }
}

TEST(Analyze, OfOneOrTwoPointsSaysWhatIsThereAndWhyTheRestIsNot) {
    const Folder folder;
    write_file(folder.path("one.txt"), "0.5 0.5\n");
    const Outcome one = run({"analyze", folder.path("one.txt"), "-o", folder.path("one.json")});
    EXPECT_EQ(one.exit_code, 0);
    expect_has(line_of(one.out, "least distance"), {"none: a set has only one point"});
    expect_has(line_of(one.out, "oscillations"), {"none: too few points"});
    expect_has(line_of(one.out, "peak power"), {" 1 "});
    EXPECT_EQ(Json::parse(content_of(folder.path("one.json")))["nearest_neighbour"], nullptr);

    write_file(folder.path("two.txt"), "0.25 0.5\n0.75 0.5\n");
    const Outcome two = run({"analyze", folder.path("two.txt"), "--torus"});
    EXPECT_EQ(two.exit_code, 0);
    expect_has(line_of(two.out, "least distance"), {" 0.5"});
    expect_has(line_of(two.out, "bond order"), {"none: too few points"});
}

TEST(AnalyzeOfFiles, WithDifferentDomainsTakesTheOneGiven) {
    const Folder folder;
    const auto json_of = [](int width) {
        return R"({"width": )" + std::to_string(width) +
               R"(, "height": 1, "points": [[0.5, 0.5], [0.25, 0.5]]})";
    };
    write_file(folder.path("a.json"), json_of(1));
    write_file(folder.path("b.json"), json_of(2));
    expect_success({"analyze", folder.path("a.json"), folder.path("b.json"), "--domain", "2x1"});
}

}  // namespace
