// The portable arithmetic against brute force and at its extremes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>

#include "portable/chord.h"
#include "portable/distance.h"
#include "portable/isqrt.h"
#include "portable/metric.h"

namespace {

using namespace lacuna::portable;

constexpr u64 kLongestSide = u64{1} << 31;

TEST(Isqrt, EqualsBruteForceForSmallNumbers) {
    u64 root = 0;
    for (u64 n = 0; n < 1'000'000; ++n) {
        if ((root + 1) * (root + 1) <= n) ++root;
        ASSERT_EQ(isqrt(n), root) << n;
    }
}

TEST(Isqrt, IsExactBesideEverySquareUpToTheLargestUnit) {
    // Roots around the powers of two and random ones: n just below, at and above their squares.
    std::mt19937_64 random(1);
    for (int i = 0; i < 1'000'000; ++i) {
        u64 root = random() >> (33 + i % 31);
        if (i < 62) root = (u64{1} << (i / 2)) + static_cast<u64>(i % 2);
        if (root < 2) continue;
        ASSERT_EQ(isqrt(root * root - 1), root - 1);
        ASSERT_EQ(isqrt(root * root), root);
        ASSERT_EQ(isqrt(root * root + 1), root);
        ASSERT_EQ(isqrt(root * root + 2 * root), root);
    }
}

TEST(Isqrt, HoldsAtTheEndOfItsRange) {
    const u64 diagonal_squared = 2 * kLongestSide * kLongestSide;
    EXPECT_EQ(isqrt(diagonal_squared - 1), 3'037'000'499u);
    EXPECT_EQ(isqrt(u64{3'037'000'499} * 3'037'000'499), 3'037'000'499u);
    EXPECT_EQ(isqrt(u64{3'037'000'499} * 3'037'000'499 - 1), 3'037'000'498u);
}

TEST(AxisDistance, WrapsAtEveryEdge) {
    for (const u32 period : {2u, 3u, 10u, 0x80000000u}) {
        EXPECT_EQ(axis_distance(0, period - 1, period), 1u);
        EXPECT_EQ(axis_distance(period - 1, 0, period), 1u);
        EXPECT_EQ(axis_distance(0, period / 2, period), period / 2);
        EXPECT_EQ(axis_distance(period / 2, 0, period), period / 2);
        EXPECT_EQ(axis_distance(period - 1, period - 1, period), 0u);
    }
}

TEST(AxisDistance, DoesNotWrapOnABox) {
    EXPECT_EQ(axis_distance(0, 0x7fffffffu, 0), 0x7fffffffu);
    EXPECT_EQ(axis_distance(0x7fffffffu, 0, 0), 0x7fffffffu);
}

TEST(NearestAndFarthestDistance, AreTheLeastAndTheMostToAnyHeightOfAStretch) {
    for (i64 y = -12; y < 24; ++y) {
        for (i64 begin = 0; begin < 12; ++begin) {
            for (i64 end = begin + 1; end <= 12; ++end) {
                i64 least = 100;
                i64 most = 0;
                for (i64 height = begin; height < end; ++height) {
                    least = std::min(least, y < height ? height - y : y - height);
                    most = std::max(most, y < height ? height - y : y - height);
                }
                EXPECT_EQ(nearest_distance(y, begin, end), least)
                    << y << ' ' << begin << ' ' << end;
                EXPECT_EQ(farthest_distance(y, begin, end), most)
                    << y << ' ' << begin << ' ' << end;
            }
        }
    }
}

TEST(Conflicts, IsStrictAtTheRadius) {
    // 3-4-5: exactly the radius apart is allowed, one unit less is not.
    EXPECT_FALSE(are_closer(10, 10, 13, 14, 0, 0, 25));
    EXPECT_TRUE(are_closer(10, 10, 13, 13, 0, 0, 25));
    EXPECT_FALSE(are_closer(0, 0, 97, 96, 100, 100, 25));
    EXPECT_TRUE(are_closer(0, 0, 98, 96, 100, 100, 25));
}

TEST(Conflicts, HoldsAcrossTheWholeDomain) {
    const u64 diagonal_squared = 2 * (kLongestSide - 1) * (kLongestSide - 1);
    EXPECT_FALSE(are_closer(0, 0, 0x7fffffffu, 0x7fffffffu, 0, 0, diagonal_squared));
    EXPECT_TRUE(are_closer(0, 0, 0x7fffffffu, 0x7fffffffu, 0, 0, diagonal_squared + 1));
}

TEST(ChordReach, CountsTheOffsetsThatConflict) {
    for (u32 radius = 1; radius <= 40; ++radius) {
        for (u32 dx = 0; dx <= radius + 1; ++dx) {
            u32 count = 0;
            while (u64{dx} * dx + u64{count} * count < u64{radius} * radius) ++count;
            ASSERT_EQ(chord_reach(dx, u64{radius} * radius), count) << radius << " " << dx;
        }
    }
}

TEST(ChordReach, HoldsForTheLargestRadius) {
    const u64 radius_squared = 2 * kLongestSide * kLongestSide;
    EXPECT_EQ(chord_reach(0, radius_squared), 3'037'000'500u);
    EXPECT_EQ(chord_reach(0x7fffffffu, radius_squared), 2'147'483'649u);
}

TEST(RadiusClass, AscendsWithTheRadiusUpToItsBound) {
    for (u32 radius = 0; radius < 5000; ++radius) {
        const u32 bound = class_bound(radius);
        ASSERT_GE(bound, radius);
        ASSERT_LE(bound, radius + radius / 4);
        ASSERT_EQ(radius_class(bound), radius_class(radius));
        ASSERT_EQ(radius_class(bound + 1), radius_class(radius) + 1);
    }
    EXPECT_EQ(class_bound(~0u), ~0u);
    EXPECT_EQ(radius_class(~0u), RADIUS_CLASSES - 1);
}

TEST(Window, CoversExactlyTheHeightsWithinReach) {
    for (const u32 height : {1u, 2u, 9u, 16u}) {
        for (u32 reach = 1; reach <= height + 3; ++reach) {
            for (u32 y = 0; y < height; ++y) {
                for (u32 other = 0; other < height; ++other) {
                    const auto is_in = [&](u32 window) {
                        return other >= window_begin(window, y, reach, height) &&
                               other < window_end(window, y, reach, height);
                    };
                    ASSERT_EQ(is_in(0), axis_distance(y, other, 0) < reach);
                    ASSERT_EQ(is_in(0) || is_in(1) || is_in(2),
                              axis_distance(y, other, height) < reach)
                        << other << " from " << y << ", reach " << reach << ", height " << height;
                }
            }
        }
    }
}

TEST(Window, HoldsForTheLargestUnits) {
    const u32 height = 1u << 31;
    for (const u32 reach : {3'037'000'500u, ~0u}) {
        EXPECT_EQ(window_begin(0, height - 1, reach, height), 0u);
        EXPECT_EQ(window_end(0, height - 1, reach, height), height);
    }
    EXPECT_EQ(window_end(2, height - 1, 3, height), 2u);
    EXPECT_EQ(window_begin(1, 0, 3, height), height - 2);
    EXPECT_EQ(window_begin(1, 5, 3, height), height);
    EXPECT_EQ(window_end(2, height - 5, 3, height), 0u);
}

}  // namespace
