// Point files of dots in several inks.
#include <gtest/gtest.h>

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "files/point_files.h"
#include "files/read_points.h"
#include "text.h"

namespace lacuna::files {
namespace layers_test {

using tests::contains;

const std::vector<Point> kPoints{{0.25, 0.5}, {0.75, 0.5}, {0.5, 0.125}};
const std::vector<Layer> kLayers{
    {{"red", {0xe0, 0x10, 0x20}}, 2}, {{"none", {1, 2, 3}}, 0}, {{"sea", {0x00, 0x83, 0xb8}}, 1}};

std::string encoded(const std::string& name, const Dots* dots = nullptr) {
    PointSet set{kPoints};
    set.layers = kLayers;
    set.dots = dots;
    return encode(set, *find_format(name));
}

std::vector<Point> decoded(const std::string& name, const std::string& bytes) {
    return decode(bytes, *find_format(name), "file").points;
}

TEST(Layers, GivenCsvThenTheLastColumnNamesTheInk) {
    EXPECT_EQ(encoded("csv"), "x,y,ink\n0.25,0.5,red\n0.75,0.5,red\n0.5,0.125,sea\n");
    const Dots dots{{0.1, 0.1, 0.2}, 10, 0, 0};
    EXPECT_TRUE(contains(encoded("csv", &dots),
                         "x,y,radius,x_mm,y_mm,radius_mm,ink\n0.25,0.5,0.1,2.5,5,1,red\n"));
}

TEST(Layers, GivenPlyThenThereIsAPropertyInk) {
    const std::string ply = encoded("ply");
    EXPECT_TRUE(contains(ply, "property uchar ink\nend_header\n0.25 0.5 0 0\n"));
    EXPECT_TRUE(contains(ply, "0.5 0.125 0 2\n"));
}

TEST(Layers, GivenJsonThenInksAreListedAndEachPointHasItsIndex) {
    const auto json = nlohmann::json::parse(encoded("json"));
    EXPECT_EQ(json.at("ink"), (std::vector<int>{0, 0, 2}));
    const auto& last = json.at("inks").at(2);
    EXPECT_EQ(last.at("name"), "sea");
    EXPECT_EQ(last.at("colour"), "#0083b8");
    EXPECT_EQ(last.at("count"), 1);
}

TEST(Layers, GivenNpyThenAThirdColumnHasTheIndex) {
    const std::string npy = encoded("npy");
    EXPECT_TRUE(contains(npy, "'shape': (3, 3)"));
    EXPECT_EQ(npy.size() % 64, 3 * 3 * sizeof(double) % 64);
    EXPECT_THROW(decoded("npy", npy), FileError) << "it might be a third coordinate";
}

TEST(Layers, GivenThePointsAloneThenReadingGivesThemBack) {
    for (const char* name : {"csv", "ply", "json"})
        EXPECT_EQ(decoded(name, encoded(name)), kPoints) << name;
}

}  // namespace layers_test
}  // namespace lacuna::files
