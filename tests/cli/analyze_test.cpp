// Given point files, `lacuna analyze` reports their numbers in words and in files.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "expectations.h"
#include "program.h"

namespace {

using namespace lacuna::test;
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

TEST(Analyze, WritesTheSameNumbersAsJsonWithTheirUnits) {
    const Folder folder;
    write_file(folder.path("a.txt"), lattice(20));
    const std::string report = folder.path("report.json");
    ASSERT_EQ(run({"analyze", folder.path("a.txt"), "--torus", "--radius", "0.04", "-o", report})
                  .exit_code,
              0);
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

TEST(Analyze, ReachesAsFarAsItIsTold) {
    const Folder folder;
    write_file(folder.path("a.txt"), lattice(40));  // by the fast sums
    const auto analyzed = [&](const std::string& farthest) {
        return run({"analyze", folder.path("a.txt"), "--torus", "--max-frequency", farthest});
    };
    const auto last_ring = [&](const std::string& farthest) {
        const Json json = Json::parse(
            run({"analyze", folder.path("a.txt"), "--torus", "--json", "--max-frequency", farthest})
                .out);
        EXPECT_EQ(json["spectrum"]["max_k_over_sqrt_count"], std::stod(farthest));
        return json["spectrum"]["radial"]["k_over_sqrt_count"].back().get<double>();
    };
    EXPECT_NEAR(last_ring("0.3"), 0.3, 0.08);
    EXPECT_NEAR(last_ring("2"), 2, 0.08);
    EXPECT_NEAR(last_ring("6"), 6, 0.08);
    expect_has(line_of(analyzed("0.3").out, "k / sqrt(count)"), {" 0.3"});
    expect_has(line_of(analyzed("1").out, "k / sqrt(count)"), {" 0.5 ", " 1"});
    EXPECT_EQ(analyzed("1").out.find("1.1 "), std::string::npos);
    expect_has(line_of(analyzed("6").out, "k / sqrt(count)"), {" 2 ", " 6"});
    EXPECT_EQ(analyzed("2").out, run({"analyze", folder.path("a.txt"), "--torus"}).out);
}

TEST(Analyze, TellsTheSameOnAnyNumberOfThreads) {
    const Folder folder;
    ASSERT_EQ(run({"sample", "--count", "3000", "-o", folder.path("a.npy"), "--quiet"}).exit_code,
              0);
    const auto told = [&](const std::string& threads) {
        return run({"analyze", folder.path("a.npy"), "--json", "--threads", threads}).out;
    };
    EXPECT_EQ(told("1"), told("3"));
    EXPECT_EQ(told("0"), told("3"));
}

TEST(Analyze, RefusesFrequenciesAndThreadsThatMakeNoSense) {
    const Folder folder;
    write_file(folder.path("a.txt"), lattice(9));
    for (const std::string farthest : {"0", "-1", "nan", "1001"}) {
        const Outcome outcome = run({"analyze", folder.path("a.txt"), "--max-frequency", farthest});
        EXPECT_EQ(outcome.exit_code, 2);
        expect_has(outcome.err, {"max-frequency", farthest});
    }
    ASSERT_EQ(run({"sample", "--count", "3000", "-o", folder.path("b.npy"), "--quiet"}).exit_code,
              0);
    const Outcome far = run({"analyze", folder.path("b.npy"), "--max-frequency", "1000"});
    EXPECT_EQ(far.exit_code, 2);
    expect_has(far.err, {"max-frequency 1000", "3000 points", "2^31"});
    const Outcome many = run({"analyze", folder.path("a.txt"), "--threads", "1025"});
    EXPECT_EQ(many.exit_code, 2);
    expect_has(many.err, {"threads 1025", "1024"});
}

TEST(Analyze, AveragesSeveralFilesAndSeveralSetsOfOne) {
    const Folder folder;
    const std::string path = folder.path("a.txt");
    std::string sets;
    Words words{"analyze", "--torus"};
    for (int seed = 0; seed < 4; ++seed) {
        const std::string name = folder.path(std::to_string(seed) + ".txt");
        ASSERT_EQ(run({"sample", "--radius", "0.04", "--torus", "--seed", std::to_string(seed),
                       "-o", name})
                      .exit_code,
                  0);
        sets += content_of(name) + "#\n";
        words.push_back(name);
    }
    write_file(folder.path("all.dat"), sets);
    const Outcome from_files = run(words);
    EXPECT_EQ(from_files.exit_code, 0);
    expect_has(line_of(from_files.out, "sets"), {" 4"});
    expect_has(line_of(from_files.out, "points a set"), {" to ", "mean "});
    EXPECT_EQ(run({"analyze", "--torus", folder.path("all.dat")}).out, from_files.out);
    EXPECT_NE(run({"analyze", "--torus", folder.path("0.txt")}).out, from_files.out);
}

TEST(Analyze, TakesDomainAndRadiusFromAJsonFileUnlessTold) {
    const Folder folder;
    const std::string path = folder.path("a.json");
    ASSERT_EQ(run({"sample", "--radius", "0.05", "--domain", "2x0.5", "-o", path}).exit_code, 0);
    const Outcome outcome = run({"analyze", path});
    expect_has(line_of(outcome.out, "domain"), {" 2 x 0.5, box"});
    expect_has(line_of(outcome.out, "radius"), {" 0.05"});
    const Outcome told = run({"analyze", path, "--domain", "3x1", "--radius", "0.1"});
    expect_has(line_of(told.out, "domain"), {" 3 x 1, box"});
    expect_has(line_of(told.out, "radius"), {" 0.1"});
}

TEST(Analyze, ReadsTheFilesOfPsaAndUtk) {
    const Folder folder;
    write_file(folder.path("a.txt"), lattice(9));
    write_file(folder.path("psa.txt"), "81\n" + lattice(9));
    write_file(folder.path("utk.dat"), lattice(9, "\t"));
    const std::string expected = run({"analyze", folder.path("a.txt")}).out;
    expect_has(expected, {"points a set            81\n"});
    EXPECT_EQ(run({"analyze", folder.path("psa.txt")}).out, expected);
    EXPECT_EQ(run({"analyze", folder.path("utk.dat")}).out, expected);
}

TEST(Analyze, ReadsStandardInput) {
    const Folder folder;
    write_file(folder.path("a.txt"), lattice(9));
    const int saved = dup(STDIN_FILENO);
    const int file = open(folder.path("a.txt").c_str(), O_RDONLY | O_CLOEXEC);
    ASSERT_GE(file, 0);
    dup2(file, STDIN_FILENO);
    const Outcome from_input = run({"analyze", "-"});
    dup2(saved, STDIN_FILENO);
    close(saved);
    close(file);
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

TEST(AnalyzeOfAFile, ThatCannotBeReadOrUsedExitsWith3AndSaysWhy) {
    const Folder folder;
    const auto outcome_of = [&](const std::string& name, const std::string& content) {
        write_file(folder.path(name), content);
        return run({"analyze", folder.path(name)});
    };
    expect_one_error(run({"analyze", folder.path("missing.txt")}), 3,
                     {folder.path("missing.txt") + ": No such file"});
    expect_one_error(outcome_of("a.txt", "# nothing\n"), 3,
                     {folder.path("a.txt") + ": there is no point to analyse"});
    expect_one_error(outcome_of("b.txt", "0.5 0.5\n1.5 0.5\n"), 3,
                     {folder.path("b.txt") + ": point 1 at (1.5, 0.5) lies outside the domain "
                                             "[0, 1] x [0, 1]: give --domain"});
    expect_one_error(outcome_of("c.dat", "0.5 0.5\n#\n0.5 -0.5\n"), 3,
                     {folder.path("c.dat") + ": set 2: point 0 at (0.5, -0.5)"});
    expect_one_error(outcome_of("d.txt", "3\n0.5 0.5\n"), 3, {"1 point: the first line says 3"});
    expect_one_error(outcome_of("e.txt", "0.5 0.5\n#\n0.25 0.5\n"), 3, {"e.txt:2: ", ".dat"});
    expect_one_error(outcome_of("f.gz", ""), 3, {".txt .csv .npy .ply .json .dat .rps"});
    expect_one_error(outcome_of("g.png", ""), 3, {"a picture"});
    expect_one_error(
        outcome_of("h.json", R"({"width": 9999, "height": 1, "points": [[0.5, 0.5]]})"), 3,
        {"h.json: domain 9999x1: ", "1000 times"});
    expect_one_error(run({"analyze", "-", "-"}), 3, {"standard input", "only once"});
}

TEST(AnalyzeOfFiles, WithDifferentDomainsExitsWith3UnlessOneIsGiven) {
    const Folder folder;
    const auto json_of = [](int width) {
        return R"({"width": )" + std::to_string(width) +
               R"(, "height": 1, "points": [[0.5, 0.5], [0.25, 0.5]]})";
    };
    write_file(folder.path("a.json"), json_of(1));
    write_file(folder.path("b.json"), json_of(2));
    const Words words{"analyze", folder.path("a.json"), folder.path("b.json")};
    expect_one_error(run(words), 3,
                     {folder.path("b.json") + ": its domain is 2x1, but ", "has 1x1"});
    EXPECT_EQ(run({words[0], words[1], words[2], "--domain", "2x1"}).exit_code, 0);
}

TEST(AnalyzeWithBadUsage, ExitsWith2AndNamesTheOption) {
    const Folder folder;
    const std::string path = folder.path("a.txt");
    write_file(path, lattice(3));
    const auto outcome_of = [&](const Words& more) {
        Words words{"analyze", path};
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    };
    expect_one_error(outcome_of({"-o", "a.xyz"}), 2, {"--output a.xyz: ", ".json .svg .pdf .png"});
    expect_one_error(outcome_of({"-o", folder.path("b.txt")}), 2, {".json .svg .pdf .png"});
    expect_one_error(outcome_of({"-o", "-", "--format", "txt"}), 2,
                     {"--format txt: ", ".json .svg .pdf .png"});
    expect_one_error(outcome_of({"-o"}), 2, {"--output", "a value must follow"});
    expect_one_error(outcome_of({"--radius", "0"}), 2, {"--radius 0:", "greater than 0"});
    expect_one_error(outcome_of({"--radius", "x"}), 2, {"--radius x:", "must be a number"});
    expect_one_error(outcome_of({"--domain", "1x0"}), 2, {"--domain 1x0:"});
    expect_one_error(outcome_of({"--domain", "1x2000"}), 2, {"--domain 1x2000:", "1000 times"});
    expect_one_error(outcome_of({"--wrong"}), 2, {"--wrong", "no such option"});
    expect_one_error(run({"analyze"}), 2, {"FILE", "lacuna analyze --help"});
    // Reported before any file is opened.
    expect_one_error(run({"analyze", "missing.txt", "--radius", "-1"}), 2, {"--radius -1:"});
    EXPECT_EQ(folder.names(), Words{"a.txt"});
}

TEST(AnalyzeWithAnOutput, ThatWouldReplaceThePointsOrCannotBeMadeLeavesAllAsItWas) {
    const Folder folder;
    const std::string path = folder.path("a.json");
    const std::string points = R"({"points": [[0.5, 0.5]]})";
    write_file(path, points);
    expect_one_error(run({"analyze", path, "-o", path}), 2,
                     {"must be another file than FILE " + path});
    EXPECT_EQ(content_of(path), points);
    expect_one_error(run({"analyze", path, "-o", folder.path("no/b.json")}), 3, {"no folder"});
}

TEST(AnalyzeInterrupted, ExitsWith130AndWritesNothing) {
    const Folder folder;
    const std::string path = folder.path("a.npy");
    ASSERT_EQ(run({"sample", "--count", "200000", "-o", path, "--quiet"}).exit_code, 0);
    Program program({"analyze", path, "-o", folder.path("a.pdf")});
    ASSERT_TRUE(program.waits_for(SIGINT));
    program.send(SIGINT);
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.exit_code, 130);
    EXPECT_EQ(outcome.out, "");
    expect_has(outcome.err, {"interrupted, nothing was written"});
    EXPECT_EQ(folder.names(), Words{"a.npy"});
}

TEST(AnalyzeHelp, BeginsWithExamplesAndNamesEveryOption) {
    const Outcome outcome = run({"analyze", "--help"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_LT(outcome.out.find("Examples:"), outcome.out.find("Options:"));
    expect_has(outcome.out.substr(outcome.out.find("Positionals:")),
               {"FILE", "--radius", "--domain", "--torus", "--output", "--quiet"});
}

}  // namespace
