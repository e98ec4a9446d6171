// `lacuna reproduce` as a user sees it: lines, files, exit codes.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "expectations.h"
#include "program.h"

namespace {

using namespace lacuna::tests;

// 64 x 48, darker to the right.
void write_image(const std::string& path) {
    std::string image = "P5 64 48 255\n";
    for (int i = 0; i < 64 * 48; ++i) image += static_cast<char>(252 - 4 * (i % 64));
    write_file(path, image);
}

TEST(Reproduce, PrintsALineANumberAndWritesNothingUnlessTold) {
    const Outcome outcome = run({"reproduce", "fig3"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 6);
    expect_has(outcome.out, {"fig3 ", "paper \"reduced\"", "band at most 1: within\n"});
}

TEST(Reproduce, WritesDataAndPictureOfEachIntoTheFolder) {
    const Folder folder;
    const Outcome outcome =
        run({"reproduce", "fig3", "fig5", "--runs", "2", "-o", folder.path("")});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
    EXPECT_EQ(folder.names(), (Words{"fig3.json", "fig3.svg", "fig5.json", "fig5.svg"}));
    const auto json = nlohmann::json::parse(content_of(folder.path("fig5.json")));
    EXPECT_EQ(json["data"]["cdf"]["sets"], 2);
    EXPECT_EQ(json["data"]["cdf"]["mean_count"], 6000);
    EXPECT_TRUE(content_of(folder.path("fig5.svg")).ends_with("</svg>\n"));
}

TEST(Reproduce, TakesItemsInAnyOrderAndOnce) {
    const std::string out =
        run({"reproduce", "--runs", "1", "--smallest-radius", "0.05", "fig3", "table2", "fig3"})
            .out;
    EXPECT_LT(out.find("table2 "), out.find("fig3 "));
    EXPECT_EQ(std::count(out.begin(), out.end(), '\n'), 12);
}

TEST(Reproduce, StipplesTheImageGiven) {
    const Folder folder;
    write_image(folder.path("a.pgm"));
    const Outcome outcome =
        run({"reproduce", "fig7", "--image", folder.path("a.pgm"), "-o", folder.path("")});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
    EXPECT_EQ(folder.names(), (Words{"a.pgm", "fig7.json", "fig7.png"}));
    expect_has(outcome.out, {"paper 20000 ", "here 20000 "});
}

TEST(Reproduce, ExitsWith1WhenANumberIsNotWithinAndWritesAllTheSame) {
    const Folder folder;
    Setting setting;
    setting.program = LACUNA_MISPRINTED;
    const Outcome outcome = run({"reproduce", "fig3", "-o", folder.path("")}, setting);
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_EQ(outcome.err, "");
    expect_has(outcome.out, {"here 100.4 ", ": within\n", "here 100.6 ", ": NOT WITHIN\n"});
    EXPECT_EQ(folder.names(), (Words{"fig3.json", "fig3.svg"}));
}

TEST(ReproduceIntoAFolder, LeavesNoHalfFileWhenTheDiskIsFull) {
    const Folder folder;
    Setting setting;
    setting.largest_file_bytes = 8000;  // fig3.json is smaller, fig3.svg larger
    const Outcome outcome = run({"reproduce", "fig3", "-o", folder.path("")}, setting);
    EXPECT_EQ(outcome.exit_code, 3);
    expect_has(outcome.err, {"fig3.svg: File too large"});
    EXPECT_EQ(folder.names(), Words{"fig3.json"});
}

}  // namespace
