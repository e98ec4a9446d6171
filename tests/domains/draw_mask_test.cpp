// Polygons on masks, compared with a test of each pixel's middle, one by one.
#include <gtest/gtest.h>
#include <lacuna/analysis.h>  // one program may include both
#include <lacuna/domains.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "domains/picture_of_mask.h"

namespace draw_mask_test {

using namespace lacuna;

std::string refusal_of(const std::vector<PolygonRing>& rings, double width, double height,
                       double edge, std::uint64_t memory = 0) {
    try {
        draw_mask(rings, width, height, edge, memory);
    } catch (const BadRequest& error) {
        return error.what();
    }
    return "";
}

// Half the diagonal of a pixel of side 1, and a little more, in case the division rounds up.
constexpr double kPixel = 0.70710678118654757 * (1 + 1e-12);

// A point in whole numbers, so that nothing is rounded. All corners below have even coordinates;
// the middles of pixels, which are four units wide, have odd ones.
struct Whole {
    std::int64_t x;
    std::int64_t y;
};

// Counts the crossings of a ray to the left.
bool is_inside(const std::vector<std::vector<Whole>>& rings, Whole at) {
    bool inside = false;
    for (const std::vector<Whole>& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            Whole low = ring[i];
            Whole high = ring[(i + 1) % ring.size()];
            if (low.y > high.y) std::swap(low, high);
            if (at.y < low.y || at.y >= high.y) continue;
            // Which side of the line: positive to its right.
            const std::int64_t side =
                (at.x - low.x) * (high.y - low.y) - (high.x - low.x) * (at.y - low.y);
            if (side >= 0) inside = !inside;
        }
    return inside;
}

// Whether a middle lies exactly on an outline, where both answers are right.
bool is_on_an_edge(const std::vector<std::vector<Whole>>& rings, Whole at) {
    for (const std::vector<Whole>& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Whole a = ring[i];
            const Whole b = ring[(i + 1) % ring.size()];
            const std::int64_t side = (at.x - a.x) * (b.y - a.y) - (b.x - a.x) * (at.y - a.y);
            if (side == 0 && at.x >= std::min(a.x, b.x) && at.x <= std::max(a.x, b.x) &&
                at.y >= std::min(a.y, b.y) && at.y <= std::max(a.y, b.y))
                return true;
        }
    return false;
}

TEST(ADrawnMask, HasThePixelsWhoseMiddlesAreInside) {
    const std::vector<PolygonRing> rings{{{1, 1}, {5, 1}, {1, 5}}};
    EXPECT_EQ(tests::picture_of(draw_mask(rings, 6, 6, kPixel)),
              "......\n"
              "......\n"
              ".#....\n"
              ".##...\n"
              ".###..\n"
              "......\n");
}

TEST(ADrawnMask, LeavesOutHolesAndWhatIsEnclosedTwice) {
    const PolygonRing outer{{0, 0}, {7, 0}, {7, 7}, {0, 7}};
    const PolygonRing hole{{1, 1}, {1, 6}, {6, 6}, {6, 1}};
    const PolygonRing island{{3, 3}, {4, 3}, {4, 4}, {3, 4}};
    const std::string expected =
        "#######\n"
        "#.....#\n"
        "#.....#\n"
        "#..#..#\n"
        "#.....#\n"
        "#.....#\n"
        "#######\n";
    EXPECT_EQ(tests::picture_of(draw_mask(std::vector{outer, hole, island}, 7, 7, kPixel)),
              expected);
    EXPECT_EQ(tests::picture_of(draw_mask(std::vector{island, outer, hole}, 7, 7, kPixel)),
              expected);
    EXPECT_EQ(
        tests::picture_of(draw_mask(std::vector{island, outer, hole, hole, hole}, 7, 7, kPixel)),
        expected);
}

TEST(ADrawnMask, IsRightPixelByPixelForRandomRings) {
    std::mt19937_64 random(20261122);
    const auto between = [&random](std::int64_t least, std::int64_t most) {
        return std::uniform_int_distribution<std::int64_t>(least, most)(random);
    };
    std::size_t asked = 0;
    for (int turn = 0; turn < 300; ++turn) {
        const auto columns = static_cast<std::uint32_t>(between(1, 40));
        const auto rows = static_cast<std::uint32_t>(between(1, 40));
        // Corners are often far beyond the domain, and often on lines with other corners.
        const std::int64_t reach = turn % 3 == 0 ? 1000 : 10;
        std::vector<std::vector<Whole>> whole(static_cast<std::size_t>(between(1, 4)));
        std::vector<PolygonRing> rings;
        for (auto& ring : whole) {
            PolygonRing points;
            for (std::int64_t i = between(3, 20); i > 0; --i) {
                ring.push_back({2 * between(-reach, 2 * columns + reach),
                                2 * between(-reach, 2 * rows + reach)});
                points.push_back({static_cast<double>(ring.back().x) / 4,
                                  static_cast<double>(ring.back().y) / 4});
            }
            rings.push_back(points);
        }
        Mask mask;
        try {
            mask = draw_mask(rings, columns, rows, kPixel);
        } catch (const BadRequest&) {
            mask = {columns, rows, std::vector<std::uint8_t>(std::size_t{columns} * rows)};
        }
        ASSERT_EQ(mask.columns, columns);
        ASSERT_EQ(mask.rows, rows);
        for (std::uint32_t row = 0; row < rows; ++row)
            for (std::uint32_t column = 0; column < columns; ++column) {
                const Whole middle{4 * std::int64_t{column} + 2,
                                   4 * std::int64_t{rows - 1 - row} + 2};
                if (is_on_an_edge(whole, middle)) continue;
                ++asked;
                ASSERT_EQ(mask.allowed[std::size_t{row} * columns + column] != 0,
                          is_inside(whole, middle))
                    << "turn " << turn << ", row " << row << ", column " << column;
            }
    }
    EXPECT_GT(asked, 50'000U);
}

TEST(ADrawnMask, IsFineEnoughForItsEdge) {
    const std::vector<PolygonRing> rings{{{0.1, 0.1}, {1.9, 0.1}, {1, 0.9}}};
    for (const double edge : {0.3, 0.07, 0.01, 0.0033}) {
        const Mask mask = draw_mask(rings, 2, 1, edge);
        EXPECT_LE(std::hypot(2.0 / mask.columns, 1.0 / mask.rows) / 2, edge * (1 + 1e-12));
        EXPECT_GT(std::hypot(2.0 / (mask.columns - 1), 1.0 / (mask.rows - 1)) / 2, edge);
    }
}

TEST(ADrawnMask, TakesWhatIsWithinTheDomainOfRingsThatReachFarBeyond) {
    const std::vector<PolygonRing> rings{
        {{-1e100, -1e100}, {1e100, -1e100}, {1e100, 2}, {-1e100, 2}}};
    EXPECT_EQ(tests::picture_of(draw_mask(rings, 2, 3, kPixel)), "..\n##\n##\n");
}

TEST(ADrawnMask, HasNothingOfRingsThatCoincide) {
    const PolygonRing ring{{0.1, 0.2}, {0.77, 0.31}, {0.5, 0.9}};
    const std::vector<PolygonRing> three{ring, ring, ring};
    EXPECT_EQ(draw_mask(three, 1, 1, 0.01).allowed,
              draw_mask(std::vector<PolygonRing>{ring}, 1, 1, 0.01).allowed);
    EXPECT_EQ(refusal_of({ring, ring}, 1, 1, 0.01),
              "inside 2 rings in [0.1, 0.77] x [0.2, 0.9]: must enclose some of the domain, [0, 1) "
              "x [0, 1), and be wider than a pixel of the mask, 0.0141");
}

TEST(ADrawnMask, TellsWhereTheRingsAreIfThatIsNotInTheDomain) {
    EXPECT_EQ(refusal_of({{{11, 45}, {12, 45}, {12, 46.5}}}, 1, 1, 0.1),
              "inside 1 ring in [11, 12] x [45, 46.5]: must enclose some of the domain, [0, 1) x "
              "[0, 1), and be wider than a pixel of the mask, 0.125");
}

TEST(ADrawnMask, IsRefusedWhereItTakesTooMuchMemory) {
    const std::vector<PolygonRing> rings{{{0, 0}, {1, 0}, {0, 1}}};
    EXPECT_EQ(refusal_of(rings, 1, 1, 1e-5, 1'000'000),
              "edge 1e-05: takes a mask of 70711 x 70711 pixels, 5 GB, of which 0.001 GB are "
              "allowed: must be coarser, such as 0.00071");
    EXPECT_EQ(refusal_of(rings, 1, 1, 0.00072, 1'000'000), "");
    EXPECT_NE(refusal_of(rings, 1, 1, 1e-300).find("must be coarser"), std::string::npos);
}

TEST(ADrawnMask, IsRefusedForNumbersThatMakeNoSense) {
    const std::vector<PolygonRing> rings{{{0, 0}, {1, 0}, {0, 1}}};
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double edge : {0.0, -1.0, nan, infinity})
        EXPECT_NE(refusal_of(rings, 1, 1, edge).find("must be a finite number greater than 0"),
                  std::string::npos);
    for (const double side : {0.0, -1.0, nan, infinity, 1e-200})
        EXPECT_NE(refusal_of(rings, side, 1, 0.1).find("the sides must lie between"),
                  std::string::npos);
    for (const double x : {nan, infinity, -1e101})
        EXPECT_NE(refusal_of({{{0, 0}, {1, 0}, {x, 1}}}, 1, 1, 0.1)
                      .find("both must be finite numbers between -1e100 and 1e100"),
                  std::string::npos);
}

TEST(ADrawnMask, TakesAHundredThousandCrossingsARow) {
    PolygonRing zigzag;
    for (int i = 0; i < 100'000; ++i) zigzag.push_back({i / 1e5, i % 2 == 0 ? -0.5 : 1.5});
    const Mask mask = draw_mask(std::vector<PolygonRing>{zigzag}, 1, 1, 0.005);
    EXPECT_EQ(mask.columns, 142U);
}

}  // namespace draw_mask_test
