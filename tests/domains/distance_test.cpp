// Distances from the outlines of polygons, from lines and from points, as they are drawn. That sets
// keep them, and fill the rest, is judged by hostile.
#include <gtest/gtest.h>
#include <lacuna/domains.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace lacuna {
namespace {

// The places nearer than the distance are a disk, a band, or the inside with a rim.
TEST(DistancesFromOutlines, AreDrawnAroundPointsLinesAndPolygons) {
    const auto open_share = [](const std::vector<PolygonRing>& rings) {
        const PolygonSet set{rings, Role::outside, 0.1};
        const Mask mask = draw_mask(std::span(&set, 1), {1, 1}, 0.0005);
        return static_cast<double>(
                   std::count(mask.allowed.begin(), mask.allowed.end(), std::uint8_t{1})) /
               static_cast<double>(mask.allowed.size());
    };
    constexpr double kDisk = 3.14159265 * 0.01;
    EXPECT_NEAR(open_share({{{0.5, 0.5}}}), 1 - kDisk, 0.002);
    EXPECT_NEAR(open_share({{{0.3, 0.5}, {0.7, 0.5}}}), 1 - kDisk - 0.4 * 0.2, 0.002);
    EXPECT_NEAR(open_share({{{0.3, 0.3}, {0.6, 0.7}}}), 1 - kDisk - 0.5 * 0.2, 0.002);
    EXPECT_NEAR(open_share({{{0.3, 0.3}, {0.6, 0.3}, {0.6, 0.6}, {0.3, 0.6}}}),
                1 - kDisk - 4 * 0.3 * 0.1 - 0.09, 0.003);
    EXPECT_NEAR(open_share({{{-0.05, 0.5}}}), 1 - 0.01 * (1.0472 - 0.5 * 0.8660), 0.002);
}

// Samples that lie near to a disk of a file of disks lie near to one of them all.
TEST(DistancesFromOutlines, WithinWhichSamplesLieAreJoined) {
    const std::vector<PolygonRing> here{{{0.3, 0.5}}}, there{{{0.8, 0.5}}};
    const std::vector<PolygonSet> near{{.rings = here, .role = Role::near, .distance = 0.2},
                                       {.rings = there, .role = Role::near, .distance = 0.1}};
    const Mask mask = draw_mask(near, {1, 1}, 0.001);
    const auto open = std::count(mask.allowed.begin(), mask.allowed.end(), std::uint8_t{1});
    EXPECT_NEAR(static_cast<double>(open) / static_cast<double>(mask.allowed.size()),
                3.14159265 * (0.04 + 0.01), 0.003);
    const PolygonSet far{.rings = here, .role = Role::near, .distance = 1e-9};
    const Mask none = draw_mask(std::span(&far, 1), {1, 1}, 0.001);
    EXPECT_EQ(std::count(none.allowed.begin(), none.allowed.end(), std::uint8_t{1}), 0);
}

TEST(Lines, AreReadFromEveryFormat) {
    const PolygonRing there_and_back{{1, 1}, {3, 1}, {3, 2}, {3, 1}};
    EXPECT_EQ(decode_lines("1 1\n3 1\n\n5 5\n", "txt", "a.txt").rings,
              (std::vector<PolygonRing>{{{1, 1}, {3, 1}}, {{5, 5}}}));
    // A ring of a .txt is closed, as it is inside of polygons, and its inside is not avoided.
    const PolygonRing around_and_back{{1, 1}, {3, 1}, {3, 2}, {1, 1}, {3, 2}, {3, 1}};
    for (const char* text : {"1 1\n3 1\n3 2\n", "1 1\n3 1\n3 2\n1 1\n"})
        EXPECT_EQ(decode_lines(text, "txt", "a.txt").rings,
                  (std::vector<PolygonRing>{around_and_back}));
    EXPECT_EQ(decode_lines(R"({"type":"GeometryCollection","geometries":[
                  {"type":"LineString","coordinates":[[1,1],[3,1],[3,2]]},
                  {"type":"Point","coordinates":[5,5]},
                  {"type":"MultiPoint","coordinates":[[6,6]]},
                  {"type":"MultiLineString","coordinates":[[[1,1],[2,2]]]},
                  {"type":"Polygon","coordinates":[[[0,0],[1,0],[0,1],[0,0]]]}]})",
                           "geojson", "a.geojson")
                  .rings,
              (std::vector<PolygonRing>{there_and_back,
                                        {{5, 5}},
                                        {{6, 6}},
                                        {{1, 1}, {2, 2}},
                                        {{0, 0}, {1, 0}, {0, 1}, {0, 0}, {0, 1}, {1, 0}}}));
    const auto of_svg = [](const std::string& inner) {
        return decode_lines("<svg viewBox='0 0 10 10'>" + inner + "</svg>", "svg", "a.svg").rings;
    };
    const std::vector<PolygonRing> upright{{{1, 9}, {3, 9}, {3, 8}, {3, 9}}};
    EXPECT_EQ(of_svg("<polyline points='1,1 3,1 3,2'/>"), upright);
    EXPECT_EQ(of_svg("<path d='M1 1 H3 V2'/>"), upright);
    const std::vector<PolygonRing> closed{{{1, 9}, {3, 9}, {3, 8}, {1, 9}, {3, 8}, {3, 9}}};
    EXPECT_EQ(of_svg("<polygon points='1,1 3,1 3,2'/>"), closed);
    EXPECT_EQ(of_svg("<path d='M1 1 H3 V2 Z'/>"), closed);
    EXPECT_EQ(of_svg("<line x1='1' y1='1' x2='3' y2='1'/>"),
              (std::vector<PolygonRing>{{{1, 9}, {3, 9}}}));
    // Outlines are closed where their inside is asked for.
    EXPECT_EQ(decode_polygons(
                  "<svg viewBox='0 0 10 10' fill-rule='evenodd'><polyline points='1,1 3,1 3,2'/>"
                  "</svg>",
                  "svg", "a.svg")
                  .rings,
              (std::vector<PolygonRing>{{{1, 9}, {3, 9}, {3, 8}}}));
}

}  // namespace
}  // namespace lacuna
