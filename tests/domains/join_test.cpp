// Polygons of a drawing joined to one set of rings, against a judge that takes each apart.
#include "domains/join.h"

#include <gtest/gtest.h>
#include <lacuna/domains.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lacuna {
namespace join_test {

using domains::Fill;
using domains::Polygon;

// How often rings go around a place, counterclockwise less clockwise, and in either direction.
struct Turns {
    int net = 0;
    int all = 0;
};

Turns turns_around(const std::vector<PolygonRing>& rings, Point at) {
    Turns turns;
    for (const PolygonRing& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point a = ring[i];
            const Point b = ring[(i + 1) % ring.size()];
            if ((a.y > at.y) == (b.y > at.y)) continue;
            const double side = (b.x - a.x) * (at.y - a.y) - (at.x - a.x) * (b.y - a.y);
            const bool is_up = b.y > a.y;
            if ((side > 0) != is_up) continue;  // the edge is on the left
            turns.net += is_up ? 1 : -1;
            ++turns.all;
        }
    return turns;
}

bool is_inside(const std::vector<Polygon>& polygons, Point at) {
    for (const auto& [rings, fill] : polygons) {
        const Turns turns = turns_around(rings, at);
        if (fill == Fill::nonzero ? turns.net != 0 : turns.all % 2 == 1) return true;
    }
    return false;
}

// What is inside of the rings, at the middles of 6 x 4 squares.
std::string mask_of(std::string_view bytes, std::string_view format) {
    const Polygons read = decode_polygons(bytes, format, "file");
    std::string picture;
    for (int row = 3; row >= 0; --row) {
        for (int column = 0; column < 6; ++column)
            picture += turns_around(read.rings, {column + 0.5, row + 0.5}).all % 2 == 0 ? '.' : '#';
        picture += '\n';
    }
    return picture;
}

std::string svg(const std::string& elements) {
    return "<svg viewBox='0 0 6 4'>" + elements + "</svg>";
}

// Corners are whole numbers. So many edges lie on others and meet at corners. Places between them
// are asked for. In each third turn there are many small polygons, of which few overlap.
TEST(JoinedPolygons, HaveTheInsideOfEachByItsOwnRule) {
    std::mt19937_64 random(20261126);
    const auto below = [&random](std::uint64_t end) { return static_cast<int>(random() % end); };
    std::size_t inside = 0, outside = 0;
    for (int turn = 0; turn < 600; ++turn) {
        const bool is_small = turn % 3 == 2;
        const std::uint64_t side = turn % 3 == 0 ? 8 : 40;
        const std::uint64_t reach = is_small ? 10 : side;
        std::vector<Polygon> polygons(is_small ? 25 : 1 + random() % 5);
        for (Polygon& polygon : polygons) {
            polygon.fill = below(2) == 0 ? Fill::nonzero : Fill::even_odd;
            polygon.rings.resize(1 + random() % 3);
            const int left = below(side - reach + 1);
            const int bottom = below(side - reach + 1);
            for (PolygonRing& ring : polygon.rings)
                for (int corners = 3 + below(6); corners > 0; --corners)
                    ring.push_back({static_cast<double>(left + below(reach)),
                                    static_cast<double>(bottom + below(reach))});
        }
        const std::vector<PolygonRing> joined = domains::join(polygons);
        for (int i = 0; i < 300; ++i) {
            const double scale = static_cast<double>(side) / 1009;
            const Point at{(below(1009) + 0.37) * scale, (below(1009) + 0.61) * scale};
            const bool expected = is_inside(polygons, at);
            ++(expected ? inside : outside);
            ASSERT_EQ(turns_around(joined, at).all % 2 == 1, expected)
                << "turn " << turn << " at " << at.x << " " << at.y;
        }
    }
    EXPECT_GT(inside, 30'000U);
    EXPECT_GT(outside, 30'000U);
}

TEST(JoinedPolygons, HaveNoRingWhereTheyOverlapOrTouch) {
    const Polygon left{{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}}};
    const Polygon overlapping{{{{1, 0}, {4, 0}, {4, 2}, {1, 2}}}};
    const Polygon touching{{{{4, 0}, {4, 2}, {5, 2}, {5, 0}}}};
    const std::vector<PolygonRing> rings = domains::join({left, overlapping, touching});
    ASSERT_EQ(rings.size(), 1U);
    for (const Point& point : rings[0]) EXPECT_TRUE(point.x == 0 || point.x == 5) << point.x;
}

TEST(JoinedPolygons, HaveABorderAroundAllTogether) {
    const Polygons read = decode_polygons(
        svg("<rect y='1' width='4' height='2'/><rect x='3' width='3' height='4'/>"), "svg", "file");
    const PolygonSet set{.rings = read.rings, .distance = 0.5};
    const Mask mask = draw_mask(std::span(&set, 1), {6, 4}, 0.7072 / 8);
    // Within the border of the left one alone, and of the right one.
    for (const Point at : {Point{3.7, 2}, Point{3.2, 2}}) {
        const auto column = static_cast<std::size_t>(at.x / 6 * mask.columns);
        const auto row = static_cast<std::size_t>((1 - at.y / 4) * mask.rows);
        EXPECT_EQ(mask.allowed[row * mask.columns + column], 1) << at.x;
    }
    EXPECT_EQ(mask.allowed[0], 0);
}

TEST(JoinedPolygons, AreUnchangedWhereThereIsOneByTheEvenOddRule) {
    const std::vector<PolygonRing> rings{{{0.1, 0}, {2, 0.3}, {1, 1}, {1.5, -1}},
                                         {{5, 5}, {6, 5}, {5, 6}}};
    EXPECT_EQ(domains::join({{rings, Fill::even_odd}}), rings);
    EXPECT_TRUE(domains::join({}).empty());
}

TEST(JoinedPolygons, MayBeVeryLargeAndVerySmall) {
    for (const double size : {1e-100, 1e-9, 1.0, 1e9, 1e100}) {
        const Polygon one{{{{0, 0}, {size, 0}, {size, size}, {0, size}}}, Fill::nonzero};
        const std::vector<PolygonRing> rings = domains::join({one, one});
        ASSERT_EQ(rings.size(), 1U) << size;
        EXPECT_EQ(turns_around(rings, {size / 2, size / 3}).all, 1);
        EXPECT_EQ(turns_around(rings, {size * 1.01, size / 3}).all, 0);
        EXPECT_EQ(turns_around(rings, {size * 0.99, size / 3}).all, 1);
    }
}

TEST(OverlappingElementsOfAnSvg, AreJoined) {
    EXPECT_EQ(
        mask_of(svg("<rect width='4' height='3'/><rect x='2' y='1' width='4' height='3'/>"), "svg"),
        "####..\n"
        "######\n"
        "######\n"
        "..####\n");
}

TEST(APathOfAnSvg, IsFilledByItsOwnRule) {
    const std::string within =
        "<path d='M0 0H6V4H0Z M1 1H5V3H1Z' fill-rule='RULE'/>";  // both go the same way around
    const auto by = [&within](const std::string& rule) {
        std::string text = within;
        return text.replace(text.find("RULE"), 4, rule);
    };
    const std::string all = "######\n######\n######\n######\n";
    const std::string with_hole = "######\n#....#\n#....#\n######\n";
    EXPECT_EQ(mask_of(svg(by("nonzero")), "svg"), all);
    EXPECT_EQ(mask_of(svg(by("evenodd")), "svg"), with_hole);
    EXPECT_EQ(mask_of(svg(by("")), "svg"), all);
    // Handed on from groups, to what is used, and overruled by a style.
    EXPECT_EQ(mask_of(svg("<g fill-rule='evenodd'><g>" + by("inherit") + "</g></g>"), "svg"),
              with_hole);
    EXPECT_EQ(mask_of(svg("<g style='fill: red; fill-rule: evenodd'>" + by("") + "</g>"), "svg"),
              with_hole);
    EXPECT_EQ(mask_of(svg("<g style='fill-rule:evenodd'>" + by("nonzero") + "</g>"), "svg"), all);
    EXPECT_EQ(mask_of("<svg viewBox='0 0 6 4' fill-rule='evenodd'>" + by("") + "</svg>", "svg"),
              with_hole);
    EXPECT_EQ(mask_of(svg("<defs><path id='a' d='M0 0H6V4H0Z M1 1H5V3H1Z'/></defs>"
                          "<use href='#a' fill-rule='evenodd'/>"),
                      "svg"),
              with_hole);
    // A ring that goes the other way around is a hole by either rule.
    EXPECT_EQ(mask_of(svg("<path d='M0 0H6V4H0Z M1 1V3H5V1Z'/>"), "svg"), with_hole);
}

TEST(AHoleOfGeoJson, IsAHoleOfItsOwnPolygon) {
    const std::string outer = "[[0,0],[6,0],[6,4],[0,4],[0,0]]";
    const std::string hole = "[[1,1],[5,1],[5,3],[1,3],[1,1]]";
    const std::string patch = "[[2,1],[4,1],[4,2],[2,2],[2,1]]";
    const auto polygons = [](const std::string& coordinates) {
        return R"({"type":"MultiPolygon","coordinates":[)" + coordinates + "]}";
    };
    EXPECT_EQ(mask_of(polygons("[" + outer + "," + hole + "]"), "geojson"),
              "######\n#....#\n#....#\n######\n");
    EXPECT_EQ(mask_of(polygons("[" + outer + "," + hole + "],[" + patch + "]"), "geojson"),
              "######\n#....#\n#.##.#\n######\n");
    EXPECT_EQ(mask_of(polygons("[" + outer + "],[" + hole + "]"), "geojson"),
              "######\n######\n######\n######\n");
}

}  // namespace join_test
}  // namespace lacuna
