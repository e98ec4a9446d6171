// Given a good request, the program writes the points where they were wanted and reports it.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "expectations.h"
#include "pictures/image.h"
#include "program.h"

namespace sample_test {

using namespace lacuna::tests;
using Names = std::vector<std::string>;

std::ptrdiff_t lines_in(const std::string& text) {
    return std::count(text.begin(), text.end(), '\n');
}

TEST(Sample, WritesToStandardOutputWhatItWritesToAFile) {
    const Folder folder;
    const Outcome to_output = run({"sample", "--radius", "0.05", "--seed", "3"});
    const Outcome to_dash = run({"sample", "--radius", "0.05", "--seed", "3", "-o", "-"});
    const Outcome to_file =
        run({"sample", "--radius", "0.05", "--seed", "3", "--output", folder.path("a.txt")});
    EXPECT_EQ(to_output.exit_code, 0);
    EXPECT_EQ(to_output.err, "");
    EXPECT_GT(lines_in(to_output.out), 250);
    EXPECT_EQ(to_dash.out, to_output.out);
    EXPECT_EQ(to_file.out, "");
    EXPECT_EQ(content_of(folder.path("a.txt")), to_output.out);
    EXPECT_EQ(folder.names(), Names{"a.txt"});
}

TEST(Sample, WritesToTheFileAfterAnEqualsSign) {
    Setting shell;
    shell.program = "/bin/sh";
    for (const std::string word : {"-o=a.txt", "-o=-y.csv", "-ob.txt", "--output=-z.npy"}) {
        const Folder folder;
        const std::string line =
            "cd " + folder.path(".") + " && exec " LACUNA_PROGRAM " sample --count 3 " + word;
        EXPECT_EQ(run({"-c", line}, shell).exit_code, 0) << word;
        EXPECT_EQ(folder.names().size(), 1U);
        EXPECT_TRUE(word.ends_with(folder.names().front())) << folder.names().front();
        EXPECT_EQ(folder.names().front().find('='), std::string::npos);
    }
}

TEST(Sample, OnPixelsWritesAPictureWithAPixelForEach) {
    const Folder folder;
    const std::string png = folder.path("mask.png"), json = folder.path("a.json");
    const Outcome outcome =
        run({"sample", "--on-pixels", "40x25", "--count", "300", "--torus", "-o", png, "-o", json});
    EXPECT_TRUE(outcome.err.starts_with("300 points on 40x25 pixels, ")) << outcome.err;
    const lacuna::pictures::Image image = lacuna::pictures::read_image(png);
    ASSERT_EQ(image.columns, 40U);
    ASSERT_EQ(image.rows, 25U);
    const auto set = nlohmann::json::parse(content_of(json));
    EXPECT_EQ(set.at("options").at("on_pixels"), "40x25");
    std::vector<double> taken(1000);
    for (const auto& point : set.at("points")) {
        const double x = point[0], y = point[1];
        taken.at(static_cast<std::size_t>((24.5 - y) * 40 + x - 0.5)) = 1;
    }
    EXPECT_EQ(image.luminance, taken);
    expect_one_error(run({"verify", json}), 2, {"made on pixels", "give --distances-only"});
    const Outcome verified = run({"verify", json, "--distances-only"});
    EXPECT_EQ(verified.exit_code, 0) << verified.out << verified.err;
    EXPECT_NE(verified.out.find("kept"), std::string::npos) << verified.out;
    const Outcome sets = run({"sample", "--on-pixels", "40x25", "--count", "300", "--seeds", "1..2",
                              "-o", folder.path("{seed}.png")});
    EXPECT_TRUE(sets.err.starts_with("2 sets of 300 points, 0.")) << sets.err;
    EXPECT_EQ(lacuna::pictures::read_image(folder.path("2.png")).rows, 25U);
}

TEST(Sample, EndsWithOneLineAboutAFileUnlessQuiet) {
    const Folder folder;
    const std::string path = folder.path("points.csv");
    const Outcome outcome = run({"sample", "--count", "100", "-o", path});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_TRUE(outcome.err.starts_with("100 points, radius 0.0")) << outcome.err;
    EXPECT_TRUE(outcome.err.ends_with("-> " + path + "\n")) << outcome.err;
    EXPECT_EQ(lines_in(outcome.err), 1);

    const Outcome quiet = run({"sample", "--count", "100", "-o", path, "--quiet"});
    EXPECT_EQ(quiet.exit_code, 0);
    EXPECT_EQ(quiet.err, "");
}

TEST(Sample, SaysInItsLastLineThatASetIsNotMaximal) {
    const Folder folder;
    const auto said = [&](Words words) {
        words.insert(words.begin(), "sample");
        words.insert(words.end(), {"-o", folder.path("a.txt")});
        return run(words).err.find(", not maximal, ") != std::string::npos;
    };
    EXPECT_FALSE(said({"--radius", "0.1"}));
    EXPECT_TRUE(said({"--count", "100"}));
    EXPECT_TRUE(said({"--radius", "0.1", "--limit", "20"}));
    EXPECT_TRUE(said({"--radius", "0.1", "--relax", "2"}));
    const std::string relaxed =
        run({"sample", "--count", "100", "--relax", "2", "-o", folder.path("a.txt")}).err;
    EXPECT_TRUE(relaxed.starts_with("100 points, not maximal, ")) << relaxed;
}

TEST(Sample, TakesEveryOptionIntoTheRequestAndTheReport) {
    const Folder folder;
    const std::string report = folder.path("report.json");
    const Outcome outcome = run({"sample",    "--radius",    "0.05",
                                 "--domain",  "2.5x1",       "--torus",
                                 "--mode",    "lines",       "--lines-per-radius",
                                 "7",         "--uniform-x", "--snap",
                                 "--limit",   "40",          "--round-size",
                                 "1",         "--seed",      "9",
                                 "--backend", "reference",   "--device",
                                 "",          "--threads",   "2",
                                 "--quiet",   "--report",    report});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(lines_in(outcome.out), 40);

    const auto json = nlohmann::json::parse(content_of(report));
    const auto expected = nlohmann::json::parse(R"({
        "width": 2.5, "height": 1.0, "boundary": "torus", "mode": "lines", "radius": 0.05,
        "count": null, "lines_per_radius": 7, "snap": true, "uniform_x": true, "limit": 40,
        "round_size": 1, "seed": 9, "backend": "reference", "device": "", "threads": 2})");
    EXPECT_EQ(json.at("request"), expected);
    EXPECT_EQ(json.at("count"), 40);
    EXPECT_EQ(json.at("maximal"), false);
    EXPECT_EQ(json.at("backend"), "reference");
}

TEST(Sample, ReportsCountsTimesMemoryAndTheHashOfThePoints) {
    const Folder folder;
    const std::string report = folder.path("report.json");
    const Outcome outcome = run({"sample", "--radius", "0.05", "--report", report});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;

    const auto json = nlohmann::json::parse(content_of(report));
    EXPECT_EQ(json.at("program"), "lacuna");
    EXPECT_EQ("lacuna " + json.at("version").get<std::string>() + "\n", run({"--version"}).out);
    EXPECT_EQ(json.at("request").at("radius"), 0.05);
    EXPECT_EQ(json.at("request").at("limit"), nullptr);
    EXPECT_EQ(json.at("request").at("mode"), "exact");
    EXPECT_EQ(json.at("request").at("lines_per_radius"), 6);
    EXPECT_EQ(json.at("count"), lines_in(outcome.out));
    EXPECT_EQ(json.at("radius"), 0.05);
    EXPECT_EQ(json.at("maximal"), true);
    EXPECT_GT(json.at("rounds"), 0);
    EXPECT_GE(json.at("draws"), json.at("count"));
    double by_verb = 0;
    for (const char* verb :
         {"invert", "locate", "admit", "subtract", "refine", "transfer", "first_use"}) {
        EXPECT_GE(json.at("seconds").at(verb).get<double>(), 0);
        by_verb += json.at("seconds").at(verb).get<double>();
    }
    EXPECT_GE(json.at("seconds").at("total").get<double>(), by_verb);
    EXPECT_GT(json.at("seconds").at("total").get<double>(), 0);
    EXPECT_TRUE(json.at("device").is_string());
    EXPECT_GT(json.at("peak_memory_bytes"), 1 << 20);
    EXPECT_EQ(json.at("points_sha256").get<std::string>().size(), 64u);

    const std::string other = folder.path("other.json");
    run({"sample", "--radius", "0.05", "--seed", "1", "--report", other});
    const auto other_json = nlohmann::json::parse(content_of(other));
    EXPECT_NE(other_json.at("points_sha256"), json.at("points_sha256"));
}

}  // namespace sample_test
