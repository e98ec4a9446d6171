// Given points, the public header writes and reads them.
#include <gtest/gtest.h>
#include <lacuna/files.h>

#include <filesystem>
#include <string>
#include <vector>

namespace public_test {

using namespace lacuna;

const std::vector<Point> kPoints{{0.1, 1.0 / 3}, {0.7, 0.2}};

TEST(WritePoints, WritesWhatReadPointsReads) {
    for (const std::string name : {"txt", "csv", "npy", "ply", "json"}) {
        const std::string path =
            (std::filesystem::path(testing::TempDir()) / ("public_points." + name)).string();
        write_points(path, kPoints);
        EXPECT_EQ(read_points(path), kPoints) << name;
        std::filesystem::remove(path);
    }
}

TEST(WritePoints, RefusesWhatItCannotWrite) {
    EXPECT_THROW(write_points("points.xyz", kPoints), BadRequest);
    EXPECT_THROW(write_points("/nowhere/at/all.csv", kPoints), FileError);
    EXPECT_THROW(read_points("/nowhere/at/all.csv"), FileError);
}

TEST(EncodePoints, TakesFormatsByNameAndTheDomain) {
    EXPECT_EQ(encode_points(kPoints, "csv").substr(0, 4), "x,y\n");
    EXPECT_EQ(encode_points(kPoints, "json", {{2, 1}, 0.5}).find("{\"width\":2.0,\"height\":1.0"),
              0U);
    const Domain away{.width = 2, .height = 1, .x0 = 448000, .y0 = -3.5};
    EXPECT_EQ(encode_points(kPoints, "json", {away, 0.5})
                  .find("{\"width\":2.0,\"height\":1.0,\"x0\":448000.0,\"y0\":-3.5,"),
              0U);
    EXPECT_NE(encode_points(kPoints, "svg", {{2, 1}, 0.5}).find("height=\"256pt\""),
              std::string::npos);
    EXPECT_THROW(encode_points(kPoints, "dat"), BadRequest);
}

}  // namespace public_test
