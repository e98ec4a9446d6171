// The format that an extension names.
#include "files/point_files.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace lacuna::files {
namespace {

TEST(Format, GivenAKnownExtensionThenItsFormatIsFound) {
    const std::vector<std::pair<std::string, std::string>> expected = {
        {"a.txt", "txt"},   {"a.csv", "csv"}, {"a.npy", "npy"}, {"a.ply", "ply"},
        {"a.json", "json"}, {"a.svg", "svg"}, {"a.pdf", "pdf"}, {"a.png", "png"}};
    for (const auto& [path, name] : expected) EXPECT_EQ(format_of(path).name(), name) << path;
}

TEST(Format, GivenCapitalsThenTheExtensionIsTheSame) {
    EXPECT_EQ(format_of("POINTS.NPY").name(), "npy");
    EXPECT_EQ(format_of("points.JsOn").name(), "json");
}

TEST(Format, GivenSeveralDotsThenTheLastOneCounts) {
    EXPECT_EQ(format_of("a.txt/b.svg.csv").name(), "csv");
}

TEST(Format, GivenStandardOutputThenTheFormatIsTxt) {
    EXPECT_EQ(format_of("-").name(), "txt");
}

TEST(Format, GivenAnUnknownExtensionOrNoneThenTheErrorNamesThePathAndTheKnownOnes) {
    for (const std::string path : {"points.jpg", "points", "points.", "a.txt/points", ".txt", ""}) {
        try {
            format_of(path);
            ADD_FAILURE() << "accepted: " << path;
        } catch (const BadRequest& error) {
            EXPECT_EQ(error.option(), "output");
            EXPECT_EQ(error.what(), "output " + path +
                                        ": the extension must be one of .txt .csv .npy .ply "
                                        ".geojson .json .svg .pdf .png");
        }
    }
}

}  // namespace
}  // namespace lacuna::files
