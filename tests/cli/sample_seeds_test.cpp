// Given --seeds, each set goes to its own file, with the same bytes as its seed alone.
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "expectations.h"
#include "program.h"

namespace sample_seeds_test {

using namespace lacuna::tests;
using Json = nlohmann::json;
using Names = std::vector<std::string>;

TEST(SampleSeeds, WritesTheBytesOfEachSeedAloneInEveryFormat) {
    const Folder folder;
    const Folder alone;
    Words words{"sample", "--radius", "0.1", "--torus", "--seeds", "8..11", "--quiet"};
    const Words extensions{"txt", "csv", "npy", "ply", "json", "svg", "pdf", "png"};
    for (const std::string& extension : extensions) {
        words.emplace_back("-o");
        words.push_back(folder.path("{seed}." + extension));
    }
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out + outcome.err, "");
    EXPECT_EQ(folder.names().size(), 4 * extensions.size());
    for (const std::string seed : {"8", "9", "10", "11"}) {
        Words one{"sample", "--radius", "0.1", "--torus", "--seed", seed, "--quiet"};
        for (const std::string& extension : extensions) {
            one.emplace_back("-o");
            one.push_back(alone.path(seed + "." + extension));
        }
        expect_success(one);
        for (const std::string& extension : extensions)
            EXPECT_EQ(content_of(folder.path(seed + "." + extension)),
                      content_of(alone.path(seed + "." + extension)))
                << seed << "." << extension;
    }
}

TEST(SampleSeeds, TakesOneSeedAndSeedsInTheNamesOfFolders) {
    const Folder folder;
    expect_success({"sample", "--count", "50", "--seeds", "3..3", "-o",
                    folder.path("{seed}-of-{seed}.txt"), "--quiet"});
    EXPECT_EQ(folder.names(), Names{"3-of-3.txt"});
}

TEST(SampleSeeds, TellsTheTotalsInOneLineAndInAReport) {
    const Folder folder;
    const Outcome outcome = run({"sample", "--count", "50", "--seeds", "0..99", "-o",
                                 folder.path("{seed}.npy"), "--report", folder.path("all.json")});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(outcome.err.starts_with("100 sets of 50 points, not maximal, ")) << outcome.err;
    const Json report = Json::parse(content_of(folder.path("all.json")));
    EXPECT_EQ(report["sets"], 100);
    EXPECT_EQ(report["count"], 5000);
    EXPECT_EQ(report["count_a_set"], Json({{"least", 50}, {"most", 50}}));
    EXPECT_EQ(report["request"]["seeds"], Json({{"first", 0}, {"last", 99}}));
    EXPECT_FALSE(report["request"].contains("seed"));
    EXPECT_EQ(folder.names().size(), 101U);
}

TEST(SampleSeeds, LeavesNoPartOfAFileWhereTheDiskIsFull) {
    const Folder folder;
    Setting setting;
    setting.largest_file_bytes = 3000;
    const Outcome outcome =
        run({"sample", "--radius", "0.05", "--seeds", "0..9", "-o", folder.path("{seed}.npy")},
            setting);
    EXPECT_EQ(outcome.exit_code, 3);
    expect_has(outcome.err, {"0.npy"});
    EXPECT_EQ(folder.names(), Names{});
}

TEST(SampleSeeds, LeavesOnlyWholeFilesWhenASignalComes) {
    const Folder folder;
    Program program({"sample", "--radius", "0.02", "--torus", "--seeds", "0..99999", "-o",
                     folder.path("{seed}.npy"), "--quiet"});
    while (program.is_running() && folder.names().size() < 20) usleep(1000);
    program.send(SIGTERM);
    EXPECT_EQ(program.wait().exit_code, 143);
    const Names names = folder.names();
    ASSERT_GE(names.size(), 10U);
    ASSERT_LT(names.size(), 100000U);
    for (const std::string& name : {names.front(), names.back()}) {
        ASSERT_TRUE(name.ends_with(".npy")) << name;
        const std::string seed = name.substr(0, name.size() - 4);
        const Folder alone;
        expect_success({"sample", "--radius", "0.02", "--torus", "--seed", seed, "-o",
                        alone.path("a.npy"), "--quiet"});
        EXPECT_EQ(content_of(folder.path(name)), content_of(alone.path("a.npy")));
    }
}

}  // namespace sample_seeds_test
