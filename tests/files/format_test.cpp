// The format that an extension names.
#include "files/point_files.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace lacuna::files {
namespace {

TEST(Format, GivenAKnownExtensionThenItsFormatIsFound) {
    const std::vector<std::pair<std::string, Format>> expected = {
        {"a.txt", Format::txt}, {"a.csv", Format::csv},   {"a.npy", Format::npy},
        {"a.ply", Format::ply}, {"a.json", Format::json}, {"a.svg", Format::svg},
        {"a.pdf", Format::pdf}, {"a.png", Format::png}};
    for (const auto& [path, format] : expected) EXPECT_EQ(format_of(path), format) << path;
}

TEST(Format, GivenCapitalsThenTheExtensionIsTheSame) {
    EXPECT_EQ(format_of("POINTS.NPY"), Format::npy);
    EXPECT_EQ(format_of("points.JsOn"), Format::json);
}

TEST(Format, GivenSeveralDotsThenTheLastOneCounts) {
    EXPECT_EQ(format_of("a.txt/b.svg.csv"), Format::csv);
}

TEST(Format, GivenStandardOutputThenTheFormatIsTxt) {
    EXPECT_EQ(format_of("-"), Format::txt);
}

TEST(Format, GivenAnUnknownExtensionOrNoneThenTheErrorNamesThePathAndTheKnownOnes) {
    for (const std::string path : {"points.jpg", "points", "points.", "a.txt/points", ".txt", ""}) {
        try {
            format_of(path);
            ADD_FAILURE() << "accepted: " << path;
        } catch (const BadRequest& error) {
            EXPECT_EQ(error.option(), "output");
            EXPECT_EQ(
                error.what(),
                "output " + path +
                    ": the extension must be one of .txt .csv .npy .ply .json .svg .pdf .png");
        }
    }
}

}  // namespace
}  // namespace lacuna::files
