// Given a point file, `lacuna verify` says in words and by its exit code what holds for it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "expectations.h"
#include "program.h"

namespace verify_test {

using namespace lacuna::tests;

// 20 x 20 points 0.05 apart; the farthest spots are 0.0354 away: maximal for any radius between.
std::string lattice(double shift = 0) {
    std::ostringstream lines;
    for (int i = 0; i < 20; ++i)
        for (int j = 0; j < 20; ++j)
            lines << (i + 0.5) / 20 << ' ' << (j + 0.5) / 20 + (i == 7 && j == 9 ? shift : 0)
                  << '\n';
    return lines.str();
}

TEST(Verify, OfAMaximalSetExitsWith0AndTellsTheNumbers) {
    const Folder folder;
    const std::string path = folder.path("a.txt");
    write_file(path, lattice());
    const Outcome outcome = run({"verify", path, "--radius", "0.04"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
    expect_has(line_of(outcome.out, "points"), {" 400"});
    expect_has(line_of(outcome.out, "radius"), {" 0.04"});
    expect_has(line_of(outcome.out, "tolerance"), {" 3.725290298461914e-09"});
    expect_has(line_of(outcome.out, "least distance"), {" 0.04999", "points ", "kept"});
    expect_has(line_of(outcome.out, "largest gap"), {" 0.03535533", "at (", "covered"});
    expect_has(
        line_of(outcome.out, "verdict"),
        {"a maximal Poisson-disk set of radius 0.04, to a tolerance of 3.725290298461914e-09"});
}

TEST(Verify, OfSeveralFilesTellsOfEachAndFailsIfOneDoes) {
    const Folder folder;
    write_file(folder.path("a.txt"), "1\n0.5 0.5\n");  // PSA's format
    write_file(folder.path("b.txt"), "0.5 0.5\n0.1 0.1\n");
    const Words both{"verify", folder.path("a.txt"), folder.path("b.txt"), "--radius", "0.8"};
    const Outcome outcome = run(both);
    EXPECT_EQ(outcome.exit_code, 1);
    expect_has(outcome.out, {folder.path("a.txt") + "\n", folder.path("b.txt") + "\n"});
    Words quiet = both;
    quiet.emplace_back("--quiet");
    EXPECT_EQ(run(quiet).exit_code, 1);
    EXPECT_EQ(run(quiet).out, "");
    expect_success({"verify", folder.path("a.txt"), "--radius", "0.8", "--quiet"});
}

TEST(Verify, AsJsonTellsTheSame) {
    const Folder folder;
    write_file(folder.path("a.txt"), lattice(-0.02));
    const Outcome outcome = run({"verify", folder.path("a.txt"), "--radius", "0.04", "--json"});
    EXPECT_EQ(outcome.exit_code, 1);
    const auto json = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(json.at("all_hold"), false);
    const auto& set = json.at("sets").at(0);
    EXPECT_EQ(set.at("points"), 400);
    EXPECT_EQ(set.at("distances_kept"), false);
    EXPECT_EQ(set.at("closest_pair").at("points"), (std::vector<int>{148, 149}));
    EXPECT_NEAR(set.at("closest_pair").at("distance").get<double>(), 0.03, 1e-9);
    EXPECT_GT(set.at("largest_gap").at("distance").get<double>(), 0.035);
    // Programs may still read the old key.
    EXPECT_EQ(set.at("emptiest_spot"), set.at("largest_gap"));
    EXPECT_EQ(set.at("domain").at("boundary"), "box");
}

TEST(Verify, OfPointsTooCloseExitsWith1AndNamesThePair) {
    const Folder folder;
    const std::string path = folder.path("a.txt");
    write_file(path, lattice(-0.02));
    const Outcome outcome = run({"verify", path, "--radius", "0.0375", "--tolerance", "0.1"});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_EQ(outcome.err, "");
    expect_has(line_of(outcome.out, "least distance"),
               {" 0.0300000", "points 148 and 149", "too close"});
    expect_has(line_of(outcome.out, "largest gap"), {"   covered"});
    expect_has(line_of(outcome.out, "verdict"),
               {"not a Poisson-disk set", "148 at (0.375, 0.425)", "149 at (0.375, 0.455)"});
}

TEST(Verify, OfASetWithAHoleExitsWith1AndNamesTheSpot) {
    const Folder folder;
    std::string lines = lattice();
    const std::string gone = "0.525 0.775\n";
    lines.erase(lines.find(gone), gone.size());
    write_file(folder.path("a.txt"), lines);
    const Outcome outcome = run({"verify", folder.path("a.txt"), "--radius", "0.04"});
    EXPECT_EQ(outcome.exit_code, 1);
    expect_has(line_of(outcome.out, "least distance"), {"kept"});
    expect_has(line_of(outcome.out, "largest gap"), {"not covered"});
    const std::string verdict = line_of(outcome.out, "verdict");
    expect_has(verdict, {"not maximal"});
    double x = 0;
    double y = 0;
    ASSERT_EQ(std::sscanf(verdict.substr(verdict.find('(')).c_str(), "(%lf, %lf)", &x, &y), 2);
    EXPECT_NEAR(x, 0.525, 1e-9);
    EXPECT_NEAR(y, 0.775, 1e-9);
}

TEST(Verify, ReadsStandardInputAndEveryFormatOfSample) {
    const Folder folder;
    std::string first;
    for (const std::string name : {"a.txt", "a.csv", "a.npy", "a.ply", "a.json"}) {
        expect_success({"sample", "-o", folder.path(name), "--radius", "0.05", "--seed", "5"});
        const Outcome outcome = run({"verify", folder.path(name), "--radius", "0.05"});
        EXPECT_EQ(outcome.exit_code, 0) << name << ": " << outcome.out;
        if (first.empty()) first = outcome.out;
        expect_has(outcome.out, {"a maximal Poisson-disk set of radius 0.05"});
        EXPECT_EQ(outcome.out, first) << name;
    }
    Setting shell;
    shell.program = "/bin/sh";
    const std::string verify = "exec " LACUNA_PROGRAM " verify - --radius 0.05 < ";
    const Outcome from_input = run({"-c", verify + folder.path("a.txt")}, shell);
    EXPECT_EQ(from_input.out, first);
}

TEST(Verify, OfAProgressiveOrderProvesEveryLevel) {
    const Folder folder;
    const std::string path = folder.path("a.json");
    expect_success({"sample", "--progressive", "--count", "500", "--torus", "--quiet", "-o", path});
    const Outcome whole = run({"verify", path});
    EXPECT_EQ(whole.exit_code, 0) << whole.out;
    expect_has(line_of(whole.out, "levels"), {" points", "each maximal"});

    // The same points in another order keep their distances, but levels have gaps.
    auto set = nlohmann::json::parse(content_of(path));
    ASSERT_GE(set.at("levels").size(), 60U);
    std::swap(set["points"][3], set["points"][499]);
    write_file(path, set.dump());
    const Outcome swapped = run({"verify", path});
    EXPECT_EQ(swapped.exit_code, 1);
    expect_has(line_of(swapped.out, "verdict"), {"the first ", " points, at radius "});
    EXPECT_EQ(run({"verify", path, "--distances-only"}).exit_code, 0);
    const auto report = nlohmann::json::parse(run({"verify", path, "--json"}).out);
    EXPECT_FALSE(report.dump().find("\"hold\":false") == std::string::npos);

    set["levels"][2]["count"] = 501;
    write_file(path, set.dump());
    const Outcome wrong = run({"verify", path});
    EXPECT_EQ(wrong.exit_code, 3);
    expect_has(wrong.err, {"a level of 501 points", "at most 500"});
}

}  // namespace verify_test
