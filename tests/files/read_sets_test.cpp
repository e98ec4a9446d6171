// Given files of this program and of PSA, their sets are read; ambiguous files are refused.
#include "files/read_points.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "files/point_files.h"
#include "folder.h"

namespace lacuna::files {
namespace read_sets_test {

using Points = std::vector<Point>;

class ReadSets : public testing::Test {
protected:
    std::string path(const std::string& name) const { return folder_.path(name); }

    PointsOfFile read(const std::string& name, std::string_view content) const {
        tests::write_file(path(name), std::string(content));
        return read_points(path(name));
    }

    // The error line without the file's path.
    std::string refusal(const std::string& name, std::string_view content) const {
        try {
            read(name, content);
        } catch (const FileError& error) {
            const std::string what = error.what();
            EXPECT_TRUE(what.starts_with(path(name) + ":")) << what;
            EXPECT_EQ(what.find('\n'), std::string::npos) << what;
            return what.substr(path(name).size() + 1);
        }
        return "not refused";
    }

private:
    const tests::Folder folder_;
};

const Points kThree{{0.25, 0.5}, {0.125, 1e-3}, {0.75, 0.875}};

TEST_F(ReadSets, OfThisProgramsFormatsAreWhatWasWritten) {
    for (const std::string name :
         {"a.txt", "a.csv", "a.npy", "a.ply", "a.geojson", "a.json", "A.TXT"}) {
        const auto file = read(name, encode({kThree, {1, 1}, 0.1}, format_of(name)));
        EXPECT_EQ(file.points, kThree) << name;
    }
}

TEST_F(ReadSets, OfAJsonFileComeWithItsDomainAndRadius) {
    const auto file = read("a.json", encode({kThree, {2.5, 1}, 0.125}, format_of("a.json")));
    EXPECT_EQ(file.domain, (Domain{2.5, 1}));
    const Domain away{.width = 2.5, .height = 1, .x0 = -1e5 / 3, .y0 = 0.1};
    EXPECT_EQ(read("a.json", encode({kThree, away, 0.125}, format_of("a.json"))).domain, away);
    EXPECT_EQ(file.radius, 0.125);

    // 0 stands for an unknown radius. Keys of other JSON objects are ignored.
    const auto unknown =
        read("a.json", R"({"radius": 0, "of": {"width": 3, "radius": 4}, "points": [[0.5, 0.5]]})");
    EXPECT_EQ(unknown.points, (Points{{0.5, 0.5}}));
    EXPECT_FALSE(unknown.radius);
    EXPECT_FALSE(unknown.domain);
    EXPECT_FALSE(read("a.json", "[[0.5, 0.5]]").domain);
}

TEST_F(ReadSets, OfAJsonFileWithHalfADomainOrANegativeRadiusAreRefused) {
    EXPECT_EQ(refusal("a.json", R"({"width": 2, "points": []})"),
              R"( "width" and "height" must be there both or neither)");
    EXPECT_EQ(refusal("a.json", R"({"radius": -1, "points": []})"),
              R"( "radius" is -1: must be a finite number of at least 0)");
}

TEST_F(ReadSets, OfPsasTextFilesBeginWithTheirCount) {
    const auto file = read("a.txt", "3\n0.25 0.5\n0.125 0.001\r\n 0.75\t0.875\n");
    EXPECT_EQ(file.points, kThree);
    EXPECT_EQ(read("a.txt", "0\n").points.size(), 0U);
}

TEST_F(ReadSets, OfPsasTextFilesWithAnotherCountAreRefused) {
    EXPECT_EQ(refusal("a.txt", "4\n0.25 0.5\n0.5 0.5\n"), " 2 points: the first line says 4");
    EXPECT_EQ(refusal("a.txt", "0\n0.25 0.5\n"), " 1 point: the first line says 0");
    // A count is a whole number, and only on the first line.
    EXPECT_EQ(refusal("a.txt", "1.5\n0.25 0.5\n"),
              R"(1: "1.5" must be two finite numbers, such as 0.25 0.75)");
    EXPECT_EQ(refusal("a.txt", "0.25 0.5\n1\n"),
              R"(2: "1" must be two finite numbers, such as 0.25 0.75)");
}

TEST_F(ReadSets, OfATextFileThatCouldHoldSeveralAreRefused) {
    EXPECT_EQ(refusal("a.txt", "0.25 0.5\n#\n0.5 0.5\n").substr(0, 3), "2: ");
    EXPECT_NE(refusal("a.txt", "0.25 0.5\n # \n\n0.5 0.5\n").find("a file for each set"),
              std::string::npos);
    // Words behind the #, and a # before or after all points, are comments.
    EXPECT_EQ(read("a.txt", "#\n0.25 0.5\n# word\n0.125 0.001\n0.75 0.875\n#\n").points, kThree);
}

TEST_F(ReadSets, OfAnUnknownFormatAreRefusedWithAllThatAreKnown) {
    EXPECT_EQ(refusal("a.xyz", ""),
              " not a point file: the extension must be one of .txt .csv .npy .ply .geojson .json");
    EXPECT_NE(refusal("a.svg", "").find("a picture"), std::string::npos);
    EXPECT_THROW(read_points(path("missing.csv")), FileError);
}

}  // namespace read_sets_test
}  // namespace lacuna::files
