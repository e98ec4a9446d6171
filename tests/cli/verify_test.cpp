// Given a point file, `lacuna verify` says in words and by its exit code what holds for it.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "expectations.h"
#include "program.h"

namespace {

using namespace lacuna::test;

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

// A spot 0.0354 from every point has room for a point at a radius of 0.02.
TEST(Verify, WithAToleranceOverAPercentOfTheRadiusProvesNoMaximalSet) {
    const Folder folder;
    write_file(folder.path("a.txt"), lattice());
    const auto verdict_with = [&](const std::string& radius, const std::string& tolerance) {
        const Outcome outcome =
            run({"verify", folder.path("a.txt"), "--radius", radius, "--tolerance", tolerance});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
        return line_of(outcome.out, "verdict");
    };
    expect_has(verdict_with("0.02", "0.02"),
               {"a Poisson-disk set of radius 0.02", "no spot is farther than 0.04 from a point",
                "not proven maximal", "over 1 %"});
    expect_has(verdict_with("0.0351", "0.00035"), {"a maximal", "to a tolerance of 0.00035"});
    expect_has(verdict_with("0.0351", "0.00036"), {"not proven maximal"});
}

TEST(Verify, OfDistancesOnlyDoesNotAskForGaps) {
    const Folder folder;
    write_file(folder.path("a.txt"), "0.1 0.1\n0.9 0.9\n");
    const Outcome outcome =
        run({"verify", folder.path("a.txt"), "--radius", "0.1", "--distances-only"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
    EXPECT_EQ(outcome.out.find("farthest"), std::string::npos);
    expect_has(line_of(outcome.out, "verdict"),
               {"a Poisson-disk set of radius 0.1", "was not asked"});
    EXPECT_EQ(
        run({"verify", folder.path("a.txt"), "--radius", "1.2", "--distances-only"}).exit_code, 1);
    expect_one_error(run({"verify", folder.path("a.txt"), "--radius", "0.1", "--distances-only",
                          "--tolerance", "0.1"}),
                     2, {"--tolerance 0.1:", "--distances-only"});
}

TEST(Verify, OfABoxTakesPointsOnItsFarEdges) {
    const Folder folder;
    write_file(folder.path("a.txt"), "1 1\n0 0.5\n0.5 0\n");
    EXPECT_EQ(run({"verify", folder.path("a.txt"), "--radius", "0.7"}).exit_code, 0);
    const Outcome torus = run({"verify", folder.path("a.txt"), "--radius", "0.7", "--torus"});
    EXPECT_EQ(torus.exit_code, 1);
    expect_has(torus.out, {"point 0 at (1, 1) lies outside the domain [0, 1) x [0, 1)"});
}

TEST(Verify, OfSeveralFilesAndSetsTellsOfEachAndFailsIfOneDoes) {
    const Folder folder;
    write_file(folder.path("a.txt"), "1\n0.5 0.5\n");  // PSA's format
    write_file(folder.path("b.dat"), "0.5 0.5\n#\n0.1 0.1\n");
    const Words both{"verify", folder.path("a.txt"), folder.path("b.dat"), "--radius", "0.8"};
    const Outcome outcome = run(both);
    EXPECT_EQ(outcome.exit_code, 1);
    expect_has(outcome.out, {folder.path("a.txt") + "\n", "b.dat: set 1\n", "b.dat: set 2\n"});
    Words quiet = both;
    quiet.emplace_back("--quiet");
    EXPECT_EQ(run(quiet).exit_code, 1);
    EXPECT_EQ(run(quiet).out, "");
    EXPECT_EQ(run({"verify", folder.path("a.txt"), "--radius", "0.8", "--quiet"}).exit_code, 0);
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

TEST(Verify, OfAPointOutsideExitsWith1AndNamesIt) {
    const Folder folder;
    write_file(folder.path("a.csv"), "x,y\n0.5,0.5\n1.5,0.5\n");
    const Outcome outside = run({"verify", folder.path("a.csv"), "--radius", "2"});
    EXPECT_EQ(outside.exit_code, 1);
    expect_has(line_of(outside.out, "verdict"), {"point 1 at (1.5, 0.5)", "[0, 1] x [0, 1]"});

    const Words in_its_domain{"verify", folder.path("a.csv"), "--radius", "0.9", "--domain", "2x1",
                              "--torus"};
    EXPECT_EQ(run(in_its_domain).exit_code, 0);
}

TEST(Verify, OfNoPointOrOnePointStillHasAVerdict) {
    const Folder folder;
    write_file(folder.path("none.txt"), "# nothing\n");
    write_file(folder.path("one.txt"), "0.5 0.5\n");
    const Outcome none = run({"verify", folder.path("none.txt"), "--radius", "5"});
    EXPECT_EQ(none.exit_code, 1);
    expect_has(none.out, {"for want of two points", "for want of a point", "not covered"});
    EXPECT_EQ(none.out.find("inf"), std::string::npos) << none.out;
    const Outcome one = run({"verify", folder.path("one.txt"), "--radius", "0.8"});
    EXPECT_EQ(one.exit_code, 0);
    expect_has(one.out, {"for want of two points", "0.70710678"});
}

TEST(Verify, ToleratesGapsAsFarAsItIsToldAndNoFarther) {
    const Folder folder;
    const std::string path = folder.path("a.txt");
    write_file(path, "0 0\n");  // the farthest spot of the unit torus: sqrt(1/2)
    const auto code_with = [&](const Words& more) {
        Words words{"verify", path, "--torus"};
        words.insert(words.end(), more.begin(), more.end());
        return run(words).exit_code;
    };
    EXPECT_EQ(code_with({"--radius", "0.707106781"}), 0);  // 1.9e-10 short
    EXPECT_EQ(code_with({"--radius", "0.707106781", "--tolerance", "0"}), 1);
    EXPECT_EQ(code_with({"--radius", "0.70710677"}), 1);  // 1.1e-8 short
    EXPECT_EQ(code_with({"--radius", "0.70710677", "--tolerance", "2e-8"}), 0);
}

TEST(Verify, ReadsStandardInputAndEveryFormatOfSample) {
    const Folder folder;
    const Words kind{"--radius", "0.05", "--seed", "5"};
    std::string first;
    for (const std::string name : {"a.txt", "a.csv", "a.npy", "a.ply", "a.json"}) {
        Words words{"sample", "-o", folder.path(name)};
        words.insert(words.end(), kind.begin(), kind.end());
        ASSERT_EQ(run(words).exit_code, 0);
        const Outcome outcome = run({"verify", folder.path(name), "--radius", "0.05"});
        EXPECT_EQ(outcome.exit_code, 0) << name << ": " << outcome.out;
        if (first.empty()) first = outcome.out;
        expect_has(outcome.out, {"a maximal Poisson-disk set of radius 0.05"});
        EXPECT_EQ(outcome.out, first) << name;
    }
    const int saved = dup(STDIN_FILENO);
    const int file = open(folder.path("a.txt").c_str(), O_RDONLY | O_CLOEXEC);
    ASSERT_GE(file, 0);
    dup2(file, STDIN_FILENO);
    const Outcome from_input = run({"verify", "-", "--radius", "0.05"});
    dup2(saved, STDIN_FILENO);
    close(saved);
    close(file);
    EXPECT_EQ(from_input.out, first);
}

TEST(Verify, ProvesWhatSampleMakesByDefaultWhateverTheDomain) {
    const Folder folder;
    const std::string path = folder.path("a.npy");
    for (const Words& domain : {Words{},
                                {"--torus"},
                                {"--domain", "2.5x0.7"},
                                {"--domain", "0.3x1.9", "--torus"},
                                {"--domain", "7e9x5e9"}}) {
        const std::string radius = domain.size() == 2 && domain[1] == "7e9x5e9" ? "1e8" : "0.02";
        for (const std::string seed : {"0", "1"}) {
            Words make{"sample", "--radius", radius, "--seed", seed, "--quiet", "-o", path};
            Words verify{"verify", path, "--radius", radius};
            make.insert(make.end(), domain.begin(), domain.end());
            verify.insert(verify.end(), domain.begin(), domain.end());
            ASSERT_EQ(run(make).exit_code, 0);
            const Outcome outcome = run(verify);
            EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
        }
    }
}

// Snapped to lines, distances hold, but gaps narrower than a strip remain.
TEST(Verify, OfASnappedSetFindsItsDistancesKeptAndARealHole) {
    const Folder folder;
    const std::string path = folder.path("a.txt");
    ASSERT_EQ(
        run({"sample", "--mode", "lines", "--radius", "0.02", "--snap", "-o", path}).exit_code, 0);
    const Outcome outcome = run({"verify", path, "--radius", "0.02"});
    EXPECT_EQ(outcome.exit_code, 1);
    expect_has(line_of(outcome.out, "least distance"), {"kept"});
    const std::string verdict = line_of(outcome.out, "verdict");
    double x = 0;
    double y = 0;
    ASSERT_EQ(std::sscanf(verdict.substr(verdict.find('(')).c_str(), "(%lf, %lf)", &x, &y), 2);

    std::istringstream points(content_of(path));
    double least = 1;
    for (double px = 0, py = 0; points >> px >> py;)
        least = std::min(least, std::hypot(px - x, py - y));
    EXPECT_GT(least, 0.02);
}

TEST(VerifyOfAFile, ThatCannotBeReadExitsWith3AndSaysWhatIsWrong) {
    const Folder folder;
    const auto verdict_of = [&](const std::string& name) {
        return run({"verify", folder.path(name), "--radius", "0.1"});
    };
    write_file(folder.path("bad.txt"), "0.5 0.5\n0.5 nan\n");
    write_file(folder.path("bad.npy"), "no array\n");
    expect_one_error(verdict_of("missing.txt"), 3, {folder.path("missing.txt") + ": No such file"});
    expect_one_error(verdict_of("bad.txt"), 3, {folder.path("bad.txt") + ":2: ", "finite"});
    expect_one_error(verdict_of("bad.npy"), 3, {folder.path("bad.npy") + ": not a .npy file"});
    expect_one_error(verdict_of("a.png"), 3, {"a picture", ".npy"});
    expect_one_error(verdict_of("a.gz"), 3, {"the extension must be one of .txt .csv .npy"});
}

TEST(VerifyWithBadUsage, ExitsWith2AndNamesTheOption) {
    const Folder folder;
    write_file(folder.path("a.txt"), "0.5 0.5\n");
    const auto outcome_of = [&](const Words& more) {
        Words words{"verify", folder.path("a.txt")};
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    };
    expect_one_error(outcome_of({}), 2, {"--radius missing"});
    expect_one_error(outcome_of({"--radius", "0"}), 2, {"--radius 0:", "greater than 0"});
    expect_one_error(outcome_of({"--radius", "1", "--tolerance", "-1"}), 2,
                     {"--tolerance -1:", "at least 0"});
    expect_one_error(outcome_of({"--radius", "1", "--domain", "1x0"}), 2, {"--domain 1x0:"});
    expect_one_error(run({"verify", "--radius", "1"}), 2, {"FILE", "lacuna verify --help"});
    // Reported before the file is opened.
    expect_one_error(run({"verify", "missing.txt", "--radius", "-1"}), 2, {"--radius -1:"});
}

TEST(VerifyHelp, BeginsWithExamplesAndNamesEveryOptionAndTheDefaultTolerance) {
    const Outcome outcome = run({"verify", "--help"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_LT(outcome.out.find("Examples:"), outcome.out.find("Options:"));
    expect_has(outcome.out.substr(outcome.out.find("Positionals:")),
               {"FILE", "--radius", "--domain", "--torus", "--tolerance", "2^-28"});
}

}  // namespace
