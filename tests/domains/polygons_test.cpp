// Polygons from files of every format, and the messages for broken files.
#include <gtest/gtest.h>
#include <lacuna/domains.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace polygons_test {

using namespace lacuna;

using Rings = std::vector<PolygonRing>;

Rings rings_of(std::string_view bytes, std::string_view format) {
    return decode_polygons(bytes, format, "file").rings;
}

std::string refusal_of(std::string_view bytes, std::string_view format) {
    try {
        decode_polygons(bytes, format, "file");
    } catch (const FileError& error) {
        return error.what();
    }
    return "";
}

// ------------------------------------------------------------------------------------------- text

TEST(RingsInText, AreEndedByBlankLinesAndComments) {
    const Rings expected{{{0, 0}, {1, 0}, {0, 1}}, {{2, 2}, {3, 2}, {3, 3}, {2.5, 4}}};
    EXPECT_EQ(rings_of("0 0\n1 0\n0 1\n\n2 2\n3 2\n3 3\n2.5 4\n", "txt"), expected);
    EXPECT_EQ(rings_of("\xef\xbb\xbf# two\r\n0 0\r\n1\t0\r\n0 1\r\n#\r\n# \r\n\r\n2 2\r\n3 2\r\n"
                       "3 3\r\n2.5 4",
                       "txt"),
              expected);
}

TEST(RingsInText, MayEndWhereTheyBegan) {
    EXPECT_EQ(rings_of("0 0\n1 0\n0 1\n0 0\n", "txt"), (Rings{{{0, 0}, {1, 0}, {0, 1}}}));
}

TEST(RingsInText, AreRefusedByLineAndValue) {
    EXPECT_EQ(refusal_of("0 0\n1 0\n\n0 1\n", "txt"),
              "file:1: a ring of 2 points: must be at least 3");
    EXPECT_EQ(refusal_of("0 0\n1 0\n1 1\n\n0 1\n0 1\n0 1\n", "txt"),
              "file:5: a ring of 1 point: must be at least 3");
    EXPECT_EQ(refusal_of("0 0\n1 x\n1 1\n", "txt"),
              "file:2: \"1 x\" must be two finite numbers, such as 0.25 0.75");
    EXPECT_EQ(refusal_of("0 0\n1 nan\n1 1\n", "txt"),
              "file:2: \"1 nan\" must be two finite numbers, such as 0.25 0.75");
    EXPECT_EQ(refusal_of("0 0\n1 1e200\n1 1\n", "txt"),
              "file:2: (1, 1e+200): both must be finite numbers between -1e100 and 1e100");
    for (const std::string_view empty : {"", "\n\n", "# nothing\n"})
        EXPECT_EQ(refusal_of(empty, "txt"),
                  "file: no polygon: there must be at least one, of three points or more");
}

// ---------------------------------------------------------------------------------------- GeoJSON

constexpr std::string_view kTriangle = R"([[0,0],[1,0,55],[0,1],[0,0]])";
const Rings kTriangles{{{0, 0}, {1, 0}, {0, 1}}};

std::string polygon(std::string_view rings) {
    return R"({"type":"Polygon","coordinates":[)" + std::string(rings) + "]}";
}

TEST(GeoJson, HasThePolygonsOfEveryKindOfObject) {
    const std::string one = polygon(kTriangle);
    const std::string feature = R"({"type":"Feature","properties":{},"geometry":)" + one + "}";
    EXPECT_EQ(rings_of(one, "geojson"), kTriangles);
    EXPECT_EQ(rings_of(feature, "json"), kTriangles);
    const std::string distant = "[[5,0],[9,0],[5,4],[5,0]]";
    EXPECT_EQ(rings_of(R"({"type":"MultiPolygon","coordinates":[[)" + std::string(kTriangle) +
                           "],[" + distant + "," + distant + "],[" + distant + "]]}",
                       "json")
                  .size(),
              2U);
    EXPECT_EQ(rings_of(R"({"type":"FeatureCollection","features":[)" + feature +
                           R"(,{"type":"Feature","geometry":null},{"type":"GeometryCollection",)"
                           R"("geometries":[{"type":"Point","coordinates":[0,0]},)" +
                           polygon(distant) + "]}]}",
                       "geojson")
                  .size(),
              2U);
}

TEST(GeoJson, IsRefusedByPlaceAndValue) {
    const auto refused = [](std::string_view bytes, std::string_view message) {
        EXPECT_EQ(refusal_of(bytes, "geojson"), "file" + std::string(message)) << bytes;
    };
    refused("", ": byte 1: cannot be read as JSON; is the file whole?");
    refused(R"({"type":"Polygon",)", ": byte 19: cannot be read as JSON; is the file whole?");
    refused("[1]", ": an array of 1: must be an object of GeoJSON");
    refused("{}", R"(: an object without "type": must be GeoJSON)");
    refused(R"({"type":3})", ": type: \"3\": must be a word, such as Polygon");
    refused(R"({"type":"Topology"})",
            ": type: \"Topology\": must be a type of GeoJSON, such as Polygon");
    refused(R"({"type":"Polygon"})", R"(: an object without "coordinates": must be GeoJSON)");
    refused(polygon("[[0,0],[1,0],[0,0]]"),
            ": coordinates[0]: a ring of 2 points: must be at least 3");
    refused(polygon("[[0,0],[1],[0,0]]"),
            ": coordinates[0][1]: an array of 1: must be [x, y], two numbers");
    refused(polygon("[[0,0],[1,null],[0,0]]"),
            ": coordinates[0][1]: an array of 2: must be [x, y], two numbers");
    refused(polygon("[[0,0],[1,-1e150],[0,0]]"),
            ": coordinates[0][1]: (1, -1e+150): both must be finite numbers between -1e100 and "
            "1e100");
    refused(polygon("[[0,0],[1,1e999],[0,0]]"),
            ": a number that no double can hold: coordinates must be finite");
    refused(R"({"type":"FeatureCollection","features":[{"type":"Feature"}]})",
            R"(: features[0]: an object without "geometry": must be GeoJSON)");
    refused(R"({"type":"Point","coordinates":[0,0]})",
            ": no polygon: there must be at least one, of three points or more");
}

// One text on each line, or after each mark of RFC 8142.
TEST(GeoJson, MayBeASequenceOfTexts) {
    const std::string one = polygon(kTriangle), other = polygon("[[5,0],[9,0],[5,4],[5,0]]");
    const std::string feature = R"({"type":"Feature","geometry":)" + other + "}";
    for (const std::string& text :
         {one + "\n" + other + "\n", one + "\r\n\r\n" + feature, "\n" + one + "\n" + other,
          "\x1e" + one + "\n\x1e" + feature + "\n", "\x1e{\n" + one.substr(1) + "\x1e" + other,
          "\xef\xbb\xbf" + one + "\n" + other})
        for (const char* format : {"json", "geojson", "geojsonl"})
            EXPECT_EQ(rings_of(text, format).size(), 2U) << text;
    EXPECT_EQ(rings_of(one + "\n", "geojson"), kTriangles);
    EXPECT_EQ(refusal_of(one + "\n" + other + "\n{\"type\":3}", "geojson"),
              "file:3: type: \"3\": must be a word, such as Polygon");
    EXPECT_EQ(refusal_of(one + "\n{\"ty", "geojson"),
              "file:2: byte 5: cannot be read as JSON; is the file whole?");
    EXPECT_EQ(refusal_of("\x1e" + one + "\n\x1e\n{}", "geojson"),
              "file:2: an object without \"type\": must be GeoJSON");
}

TEST(GeoJson, NestedWithoutEndIsRefused) {
    std::string bytes;
    for (int i = 0; i < 200'000; ++i) bytes += R"({"type":"GeometryCollection","geometries":[)";
    EXPECT_NE(refusal_of(bytes, "geojson").find("cannot be read as JSON"), std::string::npos);
    for (int i = 0; i < 200'000; ++i) bytes += "]}";
    EXPECT_NE(refusal_of(bytes, "geojson").find("more than 64 deep"), std::string::npos);
}

// ------------------------------------------------------------------------------------------ files

TEST(Polygons, AreReadByExtensionOfAnyCase) {
    const auto path = std::filesystem::path(testing::TempDir()) / "lacuna_rings.TXT";
    std::ofstream(path) << "0 0\n1 0\n0 1\n";
    EXPECT_EQ(read_polygons(path.string()).rings, kTriangles);
    std::filesystem::remove(path);
    try {
        read_polygons("folder.svg/map.shp");
        FAIL();
    } catch (const BadRequest& error) {
        EXPECT_STREQ(error.what(),
                     "inside folder.svg/map.shp: must end in .svg, .svgz, .geojson, .geojsonl, "
                     ".json or .txt");
    }
    EXPECT_THROW(read_polygons("no such file.svg"), FileError);
}

}  // namespace polygons_test
