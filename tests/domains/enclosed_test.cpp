// What rings of a GeoJSON and of a text enclose, against judges that look at one place at a time.
#include "domains/enclosed.h"

#include <gtest/gtest.h>
#include <lacuna/domains.h>

#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace lacuna {
namespace enclosed_test {

using Rings = std::vector<PolygonRing>;

bool goes_around(const PolygonRing& ring, Point at) {
    bool is_odd = false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point a = ring[i], b = ring[(i + 1) % ring.size()];
        if ((a.y > at.y) != (b.y > at.y))
            is_odd ^= at.x < a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x);
    }
    return is_odd;
}

bool is_inside(const Rings& rings, Point at) {
    return std::count_if(rings.begin(), rings.end(),
                         [&](const PolygonRing& ring) { return goes_around(ring, at); }) %
               2 ==
           1;
}

PolygonRing square(double left, double bottom, double side) {
    return {
        {left, bottom}, {left + side, bottom}, {left + side, bottom + side}, {left, bottom + side}};
}

// Corners on whole numbers, so that outlines often touch, or all over the page; of many corners
// too, and far from 0.
TEST(APolygonOfAGeoJson, IsItsShellLessAllItsHoles) {
    std::mt19937_64 random(20261128);
    const auto below = [&random](std::uint64_t end) { return static_cast<double>(random() % end); };
    std::size_t inside = 0, outside = 0;
    for (int turn = 0; turn < 1500; ++turn) {
        const double far = turn % 5 == 0 ? 5'400'000 : 0;
        const std::uint64_t side = turn % 2 == 0 ? 8 : 1000;
        const double unit = 8.0 / static_cast<double>(side);
        Rings rings(1 + random() % 5);
        for (PolygonRing& ring : rings) {
            const std::size_t corners = 3 + random() % (turn % 7 == 0 ? 60 : 3);
            for (std::size_t i = 0; i < corners; ++i)
                ring.push_back({far + unit * below(side), far + unit * below(side)});
        }
        if (random() % 4 == 0) rings.push_back(rings[random() % rings.size()]);
        const Rings made = domains::shell_less_holes(rings);
        for (int spot = 0; spot < 100; ++spot) {
            const Point at{far + below(8) + 0.337, far + below(8) + 0.711};
            bool wanted = goes_around(rings.front(), at);
            for (std::size_t i = 1; i < rings.size(); ++i) wanted &= !goes_around(rings[i], at);
            ASSERT_EQ(is_inside(made, at), wanted)
                << "turn " << turn << " at " << at.x << ", " << at.y;
            (wanted ? inside : outside) += 1;
        }
    }
    EXPECT_GT(inside, 10'000U);
    EXPECT_GT(outside, 10'000U);
}

TEST(APolygonOfAGeoJson, WhoseHolesLieWithinItKeepsItsRingsToTheLastBit) {
    const PolygonRing shell{{1.1, 0.1}, {9.3, 0.7}, {9.9, 9.1}, {0.3, 8.9}};
    const PolygonRing hole = square(2.2, 2.3, 1.7);
    for (const Rings& rings : std::vector<Rings>{
             {shell},
             {shell, hole, square(5.1, 5.2, 2.6)},
             {shell, hole, {hole[2], {5.7, 4}, {4, 5.9}}},   // touch at a corner
             {square(0, 0, 9), {{0, 4.5}, {3, 3}, {3, 6}}},  // touches the shell
         })
        EXPECT_EQ(domains::shell_less_holes(rings), rings);
    const PolygonRing apart = square(20, 20, 3), inner = square(3, 3, 0.1);
    EXPECT_EQ(domains::shell_less_holes({shell, inner, hole, apart}), (Rings{shell, hole}));
    EXPECT_EQ(domains::shell_less_holes({hole, shell, inner}), Rings{});
    const Rings none = domains::shell_less_holes({shell, shell, hole});
    EXPECT_FALSE(is_inside(none, {3, 3}) || is_inside(none, {5, 5}));
}

// Squares as sets of unit squares.
using Cells = std::bitset<400>;

Cells cells_in(const Rings& rings) {
    Cells cells;
    for (std::size_t i = 0; i < 400; ++i)
        cells[i] = is_inside(
            rings, {static_cast<double>(i % 20) + 0.5, static_cast<double>(i / 20) + 0.5});
    return cells;
}

// Rings that overlap in part, or are the same, are united, also by way of others. Of these unions
// an odd number is around a place inside.
Cells wanted_of(const std::vector<Cells>& rings) {
    std::vector<std::size_t> group(rings.size());
    for (std::size_t i = 0; i < rings.size(); ++i) {
        group[i] = i;
        for (std::size_t j = 0; j < i; ++j) {
            const Cells both = rings[i] & rings[j];
            const bool is_nested = (both == rings[i]) != (both == rings[j]);
            const std::size_t old = group[j];
            if (both.any() && !is_nested) std::replace(group.begin(), group.end(), old, i);
        }
    }
    Cells wanted;
    for (std::size_t i = 0; i < rings.size(); ++i) {
        Cells united;
        for (std::size_t j = 0; j < rings.size(); ++j)
            if (group[j] == i) united |= rings[j];
        wanted ^= united;
    }
    return wanted;
}

TEST(RingsOfAText, AreJoinedWhereTheyOverlapInPartAndHolesWhereTheyLieInOthers) {
    std::mt19937_64 random(20261129);
    std::size_t joined_ones = 0, holes = 0;
    for (int turn = 0; turn < 1500; ++turn) {
        Rings rings;
        std::vector<Cells> parts;
        for (std::size_t i = 0; i < 2 + random() % 4; ++i) {
            const auto side = 1 + random() % 16;
            const auto at = [&] { return static_cast<double>(random() % (21 - side)); };
            rings.push_back(square(at(), at(), static_cast<double>(side)));
            parts.push_back(cells_in({rings.back()}));
        }
        if (turn % 8 == 0) {
            rings.push_back(rings.front());
            parts.push_back(parts.front());
        }
        const Rings made = joined(rings);
        const Cells wanted = wanted_of(parts), odd = cells_in(rings);
        ASSERT_EQ(cells_in(made), wanted) << "turn " << turn;
        if (wanted != odd) ++joined_ones;
        if (wanted == odd && made.size() > 1) ++holes;
    }
    EXPECT_GT(joined_ones, 300U);
    EXPECT_GT(holes, 300U);
}

TEST(RingsOfAText, ThatDoNotOverlapInPartStayAsTheyAre) {
    const PolygonRing shell{{1.1, 0.1}, {9.3, 0.7}, {9.9, 9.1}, {0.3, 8.9}};
    const double inf = std::numeric_limits<double>::infinity();
    for (const Rings& rings : std::vector<Rings>{
             {},
             {shell, square(2.2, 2.3, 3.7), square(3.1, 3.1, 0.3)},  // an island in a hole
             {square(0, 0, 1), square(1, 0, 1), square(2, 1, 1)},    // neighbours
             {{{3, 3}}, {{0, 0}, {9, 9}}, shell},                    // a point, and a line
             {square(0, 0, 5), square(2, 2, inf)},                   // is refused later on
         })
        EXPECT_EQ(joined(rings), rings);
    const Rings pair = joined({square(0, 0, 10), square(5, 5, 10), square(30.1, 0.3, 0.7)});
    EXPECT_EQ(pair.size(), 2U);
    EXPECT_NE(std::find(pair.begin(), pair.end(), square(30.1, 0.3, 0.7)), pair.end());
}

// Time that grows with the square of the number of rings would not end.
TEST(RingsOfAText, MayBeManyAndHaveManyCorners) {
    Rings rings{{}};
    constexpr int kCorners = 200'000, kSide = 100;
    for (int i = 0; i < kCorners; ++i) {
        const double turn = 2 * M_PI * i / kCorners, far = 1000 + 10 * std::sin(7001 * turn);
        rings.front().push_back({far * std::cos(turn), far * std::sin(turn)});
    }
    for (int i = 0; i < kSide * kSide; ++i)
        rings.push_back(square(-500 + 10 * (i % kSide), -500 + 10 * (i / kSide), 10));
    EXPECT_EQ(joined(rings), rings);
    EXPECT_EQ(domains::shell_less_holes(rings), rings);
}

TEST(Polygons, OfAFileAreWhatItsFormatSays) {
    const auto area_of = [](const std::string& bytes, const char* format) {
        return cells_in(decode_polygons(bytes, format, "file").rings).count();
    };
    const std::string shell = "[[0,0],[10,0],[10,10],[0,10],[0,0]]";
    const std::string hole = "[[5,5],[15,5],[15,15],[5,15],[5,5]]";
    EXPECT_EQ(area_of(R"({"type":"Polygon","coordinates":[)" + shell + "," + hole + "]}", "json"),
              75U);
    EXPECT_EQ(area_of(R"({"type":"MultiPolygon","coordinates":[[)" + shell + "," + hole + "," +
                          hole + "],[" + hole + "]]}",
                      "json"),
              175U);
    EXPECT_EQ(area_of("0 0\n10 0\n10 10\n0 10\n\n5 5\n15 5\n15 15\n5 15\n", "txt"), 175U);
}

}  // namespace enclosed_test
}  // namespace lacuna
