// Polygons on masks, compared with a test of each pixel, one by one.
#include <gtest/gtest.h>
#include <lacuna/analysis.h>  // one program may include both
#include <lacuna/domains.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "domains/picture_of_mask.h"
#include "plan/mask_tree.h"
#include "refusal.h"

namespace draw_mask_test {

using namespace lacuna;

std::uint8_t merge(std::uint8_t a, std::uint8_t b) {
    return a == b ? a : std::uint8_t{ALLOWED_SOME};
}

std::string refusal_of(const std::vector<PolygonRing>& rings, double width, double height,
                       double edge, std::uint64_t memory = 0) {
    try {
        draw_mask(rings, {width, height}, edge, memory);
    } catch (const BadRequest& error) {
        return error.what();
    }
    return "";
}

bool is_empty(const Mask& mask) {
    return std::count(mask.allowed.begin(), mask.allowed.end(), 0) ==
           static_cast<std::ptrdiff_t>(mask.allowed.size());
}

// The diagonal of a pixel of side 1, and a little more, for what samplers round.
constexpr double kPixel = 1.4142135623730951 * (1 + 1e-6);

double to_segment(Point p, Point a, Point b) {
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double squared = dx * dx + dy * dy;
    const double along = (p.x - a.x) * dx + (p.y - a.y) * dy;
    const double t = squared > 0 ? std::clamp(along / squared, 0.0, 1.0) : 0;
    return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

// The side of the line from a to b on which p lies.
double side_of(Point p, Point a, Point b) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

// The distance of a segment from a rectangle.
double to_rectangle(Point a, Point b, Point low, Point high) {
    const std::array<Point, 4> corners{low, Point{high.x, low.y}, high, Point{low.x, high.y}};
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 4; ++i) {
        const Point p = corners[i], q = corners[(i + 1) % 4];
        least = std::min(least, to_segment(p, a, b));
        if (side_of(p, a, b) * side_of(q, a, b) < 0 && side_of(a, p, q) * side_of(b, p, q) < 0)
            return 0;
    }
    for (const Point end : {a, b})
        least = std::min(least, std::hypot(std::max({low.x - end.x, 0.0, end.x - high.x}),
                                           std::max({low.y - end.y, 0.0, end.y - high.y})));
    return least;
}

// Whether samples may lie on all of a pixel. Where an edge touches it or lies at its distance to
// the last digits, `is_close` is set.
bool is_allowed(const std::vector<PolygonSet>& sets, Point low, Point high, double margin,
                bool& is_close) {
    const Point middle{(low.x + high.x) / 2, (low.y + high.y) / 2};
    bool is_inside_some = std::all_of(sets.begin(), sets.end(),
                                      [](const PolygonSet& set) { return is_forbidden(set.role); });
    bool is_left_open = true;
    for (const PolygonSet& set : sets) {
        bool inside = false;
        double least = std::numeric_limits<double>::infinity();
        for (const PolygonRing& ring : set.rings)
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Point a = ring[i], b = ring[(i + 1) % ring.size()];
                least = std::min(least, to_rectangle(a, b, low, high));
                if ((a.y > middle.y) != (b.y > middle.y))
                    inside ^= middle.x < a.x + (middle.y - a.y) / (b.y - a.y) * (b.x - a.x);
            }
        is_close = is_close || std::abs(least - set.distance - margin) < 1e-9;
        const bool is_near = least <= set.distance + margin;
        if (is_forbidden(set.role))
            is_left_open = is_left_open && !inside && !is_near;
        else
            is_inside_some = is_inside_some || (inside && !is_near);
    }
    return is_inside_some && is_left_open;
}

TEST(ADrawnMask, HasThePixelsThatLieInsideWholly) {
    const std::vector<PolygonRing> rings{{{0.9, 0.9}, {5.2, 0.9}, {0.9, 5.2}}};
    EXPECT_EQ(tests::picture_of(draw_mask(rings, {6, 6}, kPixel)),
              "......\n"
              "......\n"
              ".#....\n"
              ".##...\n"
              ".###..\n"
              "......\n");
}

TEST(ADrawnMask, LeavesOutHolesAndWhatIsEnclosedTwice) {
    const PolygonRing outer{{-0.1, -0.1}, {7.1, -0.1}, {7.1, 7.1}, {-0.1, 7.1}};
    const PolygonRing hole{{1.1, 1.1}, {1.1, 5.9}, {5.9, 5.9}, {5.9, 1.1}};
    const PolygonRing island{{2.9, 2.9}, {4.1, 2.9}, {4.1, 4.1}, {2.9, 4.1}};
    const std::string expected =
        "#######\n"
        "#.....#\n"
        "#.....#\n"
        "#..#..#\n"
        "#.....#\n"
        "#.....#\n"
        "#######\n";
    EXPECT_EQ(tests::picture_of(draw_mask(std::vector{outer, hole, island}, {7, 7}, kPixel)),
              expected);
    EXPECT_EQ(tests::picture_of(draw_mask(std::vector{island, outer, hole}, {7, 7}, kPixel)),
              expected);
    EXPECT_EQ(
        tests::picture_of(draw_mask(std::vector{island, outer, hole, hole, hole}, {7, 7}, kPixel)),
        expected);
}

TEST(ADrawnMask, IsRightPixelByPixelForRandomSets) {
    std::mt19937_64 random(20261122);
    const auto share = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    std::size_t asked = 0, allowed = 0;
    for (int turn = 0; turn < 300; ++turn) {
        const auto side = [&] { return static_cast<double>(1 + random() % 40); };
        const double width = side(), height = side();
        // Corners are often far beyond the domain. Rings of one or two points are obstacles.
        const double reach = turn % 3 == 0 ? 20 : 0.3;
        const std::size_t least = turn % 5 == 0 ? 1 : 3;
        std::vector<std::vector<PolygonRing>> rings(1 + random() % 4);
        std::vector<PolygonSet> sets;
        for (auto& own : rings) {
            for (std::size_t k = random() % 3 + 1; k > 0; --k) {
                PolygonRing& ring = own.emplace_back();
                for (std::size_t i = random() % 9 + least; i > 0; --i)
                    ring.push_back({((1 + 2 * reach) * share() - reach) * width,
                                    ((1 + 2 * reach) * share() - reach) * height});
            }
            sets.push_back({.rings = own,
                            .role = random() % 2 == 0 ? Role::outside : Role::inside,
                            .distance = random() % 2 == 0 ? 0 : 4 * share()});
        }
        Mask mask;
        try {
            mask = draw_mask(sets, {width, height}, kPixel);
        } catch (const BadRequest&) {
            continue;
        }
        ASSERT_EQ(mask.columns, width);
        ASSERT_EQ(mask.rows, height);
        for (std::uint32_t row = 0; row < mask.rows; ++row)
            for (std::uint32_t column = 0; column < mask.columns; ++column) {
                const Point low{1.0 * column, 1.0 * (mask.rows - 1 - row)};
                bool is_close = false;
                const bool wanted = is_allowed(sets, low, {low.x + 1, low.y + 1},
                                               std::max(width, height) * 0x1p-27, is_close);
                if (is_close) continue;
                ++asked;
                allowed += wanted;
                ASSERT_EQ(mask.allowed[std::size_t{row} * mask.columns + column] != 0, wanted)
                    << "turn " << turn << ", row " << row << ", column " << column;
            }
    }
    EXPECT_GT(asked, 50'000U);
    EXPECT_GT(allowed, 5'000U);
}

TEST(ADrawnMask, IsFineEnoughForItsEdge) {
    const std::vector<PolygonRing> rings{{{0.1, 0.1}, {1.9, 0.1}, {1, 0.9}}};
    for (const double edge : {0.3, 0.07, 0.01, 0.0033}) {
        const Mask mask = draw_mask(rings, {2, 1}, edge);
        EXPECT_LE(std::hypot(2.0 / mask.columns, 1.0 / mask.rows), edge);
        EXPECT_GT(std::hypot(2.0 / (mask.columns - 1), 1.0 / (mask.rows - 1)), edge * (1 - 1e-4));
    }
}

TEST(ADrawnMask, TakesWhatIsWithinTheDomainOfRingsThatReachFarBeyond) {
    const std::vector<PolygonRing> rings{
        {{-1e100, -1e100}, {1e100, -1e100}, {1e100, 2.1}, {-1e100, 2.1}}};
    EXPECT_EQ(tests::picture_of(draw_mask(rings, {2, 3}, kPixel)), "..\n##\n##\n");
}

TEST(ADrawnMask, HasNothingOfRingsThatCoincide) {
    const PolygonRing ring{{0.1, 0.2}, {0.77, 0.31}, {0.5, 0.9}};
    const std::vector<PolygonRing> three{ring, ring, ring};
    EXPECT_EQ(draw_mask(three, {1, 1}, 0.01).allowed,
              draw_mask(std::vector<PolygonRing>{ring}, {1, 1}, 0.01).allowed);
    EXPECT_TRUE(is_empty(draw_mask(std::vector<PolygonRing>{ring, ring}, {1, 1}, 0.01)));
}

// One file may serve all parts of a map, whether anything of it lies in a part or not.
TEST(ADrawnMask, MayHaveNoPixel) {
    const std::vector<PolygonRing> all{{{-1, -1}, {2, -1}, {2, 2}, {-1, 2}}};
    const std::vector<PolygonRing> apart{{{11, 45}, {12, 45}, {12, 46.5}}};
    const std::vector<PolygonRing> thin{{{0.2, 0.1}, {0.5, 0.1}, {0.5, 0.1001}}};
    for (const std::vector<PolygonSet>& sets :
         std::vector<std::vector<PolygonSet>>{{{apart}},
                                              {{thin}},
                                              {{all, Role::outside}},
                                              {{apart}, {apart, Role::outside}},
                                              {{all}, {all, Role::outside}},
                                              {{apart, Role::near, 2}}})
        EXPECT_TRUE(is_empty(draw_mask(sets, {1, 1}, 0.1)));
    for (const std::vector<PolygonSet>& sets :
         std::vector<std::vector<PolygonSet>>{{{apart, Role::outside}},
                                              {{apart, Role::outside, 2}},
                                              {{all}, {apart}},
                                              {{all}, {apart, Role::outside}}}) {
        const Mask mask = draw_mask(sets, {1, 1}, 0.1);
        EXPECT_EQ(std::count(mask.allowed.begin(), mask.allowed.end(), 0), 0);
    }
}

TEST(ADrawnMask, IsRefusedWhereItTakesTooMuchMemory) {
    const std::vector<PolygonRing> rings{{{0, 0}, {1, 0}, {0, 1}}};
    EXPECT_EQ(refusal_of(rings, 1, 1, 1e-5, 1'000'000),
              "edge 1e-05: takes a mask of 141633 x 141633 pixels, 20.1 GB, of which 0.001 GB are "
              "allowed: must be coarser, such as 0.0014");
    EXPECT_EQ(refusal_of(rings, 1, 1, 0.00143, 1'000'000), "");
    EXPECT_NE(refusal_of(rings, 1, 1, 1e-300).find("must be at least"), std::string::npos);
}

TEST(ADrawnMask, IsRefusedForNumbersThatMakeNoSense) {
    const std::vector<PolygonRing> rings{{{0, 0}, {1, 0}, {0, 1}}};
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double edge : {0.0, -1.0, nan, infinity})
        EXPECT_NE(refusal_of(rings, 1, 1, edge).find("must be a finite number greater than 0"),
                  std::string::npos);
    for (const double side : {0.0, -1.0, nan, infinity, 1e-200})
        EXPECT_NE(refusal_of(rings, side, 1, 0.1).find("side"), std::string::npos);
    for (const double x : {nan, infinity, -1e101})
        EXPECT_NE(refusal_of({{{0, 0}, {1, 0}, {x, 1}}}, 1, 1, 0.1)
                      .find("both must be finite numbers between -1e100 and 1e100"),
                  std::string::npos);
}

TEST(ADrawnMask, TakesAHundredThousandCrossingsARow) {
    PolygonRing zigzag{{0.5, 1.5}, {0.5, 2}, {-1, 2}, {-1, -1}, {2, -1}};
    for (int i = 100'000; i > 0; --i) zigzag.push_back({0.6 + i / 1e5, i % 2 == 0 ? -0.5 : 1.5});
    const Mask mask = draw_mask(std::vector<PolygonRing>{zigzag}, {1, 1}, 0.005);
    EXPECT_EQ(mask.columns, 283U);
    EXPECT_EQ(mask.allowed[0], 1);
    EXPECT_EQ(mask.allowed[282], 0);
}

// The tree of a mask has the values of a pyramid over all of its pixels, and takes little memory.
TEST(DrawnPlaces, HaveThePixelsOfAMaskInATree) {
    std::mt19937_64 random(3);
    const std::vector<PolygonRing> rings{{{0.13, 0.1}, {0.21, 0.12}, {0.17, 0.2}},
                                         {{0.8, 0.7}, {0.97, 0.9}, {0.7, 0.95}}};
    const PolygonSet set{rings};
    for (const double height : {1.0, 0.97}) {
        const Mask dense = draw_mask(std::span(&set, 1), {1, height}, 0.004);
        const MaskTree tree(dense);
        const Mask places = draw_places(std::span(&set, 1), {1, height}, 0.004);
        const MaskTree& drawn = places.drawn->tree;
        EXPECT_EQ(tree.nodes().size(), drawn.nodes().size());
        EXPECT_LT(drawn.nodes().size() * 40, dense.allowed.size());
        std::vector<std::uint8_t> values;
        for (std::uint32_t column = 0; column < dense.columns; ++column)
            for (std::uint32_t row = 0; row < dense.rows; ++row)
                values.push_back(
                    dense.allowed[std::size_t{dense.rows - 1 - row} * dense.columns + column] != 0
                        ? ALLOWED_ALL
                        : ALLOWED_NONE);
        const Pyramid<std::uint8_t, merge> pyramid(dense.columns, dense.rows, values);
        for (int i = 0; i < 20'000; ++i) {
            const auto range = [&](std::uint32_t pixels) {
                const auto a = static_cast<std::uint32_t>(random() % pixels);
                const auto b = static_cast<std::uint32_t>(random() % (i % 2 == 0 ? 9 : pixels));
                return PixelRange{a, std::min(a + b, pixels - 1)};
            };
            const PixelRange columns = range(dense.columns), rows = range(dense.rows);
            ASSERT_EQ(tree.over(columns, rows), pyramid.over(columns, rows));
            ASSERT_EQ(drawn.over(columns, rows), pyramid.over(columns, rows));
            ASSERT_EQ(drawn.at(columns.first, rows.first), pyramid.at(columns.first, rows.first));
        }
    }
}

// Two islands cost the same in an extent of 3,000 and of a million: their own outlines.
TEST(DrawnPlaces, CostByTheirOutlinesWhateverTheExtent) {
    for (const double extent : {3e3, 1e6}) {
        std::vector<PolygonRing> rings;
        for (const double at : {0.0, extent - 6})
            rings.push_back({{at, at}, {at + 6, at}, {at + 6, at + 6}, {at, at + 6}});
        const PolygonSet set{rings};
        const Mask mask = draw_places(std::span(&set, 1), {extent, extent}, 0.0625);
        EXPECT_LT(mask.drawn->tree.nodes().size(), 1200U);
        EXPECT_NEAR(mask.drawn->tree.allowed_share() * extent * extent, 72, 3);
    }
}

// Points on all edges and corners, as far as doubles can lie there; samples lie on none by choice.
TEST(DrawnPlaces, HoldKeptPointsOnTheirOutlines) {
    for (const Point corner : {Point{0, 0}, Point{448000.25, 5411000.5}}) {
        const std::vector<PolygonRing> rings{{{corner.x + 1, corner.y + 1},
                                              {corner.x + 5.3, corner.y + 1},
                                              {corner.x + 6.1, corner.y + 4.7},
                                              {corner.x + 1, corner.y + 5}}};
        const Domain domain{.width = 8, .height = 8, .x0 = corner.x, .y0 = corner.y};
        for (const double distance : {0.0, 0.5})
            for (const Role role : {Role::inside, Role::outside}) {
                const PolygonSet set{rings, role, distance};
                const Mask mask = draw_places(std::span(&set, 1), domain, 0.01);
                for (std::size_t i = 0; i < 4; ++i)
                    for (int step = 0; step <= 7; ++step) {
                        const Point a = rings[0][i], b = rings[0][(i + 1) % 4];
                        const Point along{b.x - a.x, b.y - a.y};
                        const double length = std::hypot(along.x, along.y);
                        const double sign = role == Role::outside ? -1 : 1;
                        const auto at = [&](double beyond) {
                            const double out =
                                sign * distance - beyond;  // to the left, which is inside
                            return Point{a.x + step / 7.0 * along.x - out * along.y / length,
                                         a.y + step / 7.0 * along.y + out * along.x / length};
                        };
                        const bool is_near_corner = distance > 0 && (step < 2 || step > 5);
                        if (is_near_corner) continue;
                        EXPECT_TRUE(mask.drawn->keeps(at(0))) << i << " " << step;
                        if (step == 0 || step == 7) continue;
                        EXPECT_FALSE(mask.drawn->keeps(at(sign * 1e-6))) << i << " " << step;
                    }
            }
    }
}

TEST(TheDomainAroundPlaces, ReachesAsFarAsTheyDo) {
    const auto domain_of = [](std::vector<PolygonRing> rings, double distance = 0) {
        return domain_around({.outlines = {{.polygons = {std::move(rings), {}},
                                            .role = Role::outside,
                                            .distance = distance}}});
    };
    const auto around = [&](Point far, double distance = 0) {
        return domain_of({{{0.2, 0.1}, {0.5, 0.2}, far}}, distance);
    };
    EXPECT_EQ(around({0.3, 0.9}), Domain{});
    EXPECT_EQ(around({3, 0.9}), (Domain{3, 0.9}));
    EXPECT_EQ(domain_around({}), Domain{});
    // Far from (0, 0), or beyond it, the domain is the box.
    EXPECT_EQ(around({-0.3, 0.9}), (Domain{.width = 0.8, .height = 0.8, .x0 = -0.3, .y0 = 0.1}));
    // A plot of 2 m far away: doubles are too coarse for a domain of its size.
    EXPECT_EQ(domain_of({{{448000.25, 5411000.5}, {448002.25, 5411000.5}, {448002.25, 5411001}}}),
              (Domain{.width = 8, .height = 8, .x0 = 448000.25, .y0 = 5411000.5}));
    EXPECT_EQ(domain_of({{{448251, 5411932}, {448900, 5411950}, {448800, 5412400}}}),
              (Domain{.width = 649, .height = 468, .x0 = 448251, .y0 = 5411932}));
    EXPECT_EQ(
        tests::refusal_of([&] {
            domain_of({{{448251, 5411932}, {448900, 5411932}}});
        }),
        "domain missing: the places given lie in [448251, 448900] x [5411932, 5411932], which "
        "has no area: give a domain that has one");
    EXPECT_EQ(tests::refusal_of([&] {
                  around({0.3, std::nan("")});
              }).substr(0, 15),
              "outside ring 0:");
    EXPECT_EQ(tests::refusal_of([&] { around({0.3, 0.4}, -1); }).substr(0, 9), "border -1");
}

}  // namespace draw_mask_test
