// Columns and windows against brute force: nothing within reach is ever left out or seen twice.
#include "portable/column.h"

#include <gtest/gtest.h>

#include <set>

#include "portable/distance.h"
#include "portable/window.h"

namespace {

using namespace lacuna::portable;

TEST(Column, SharesOutEveryLineOnceAndEvenly) {
    for (u32 lines = 1; lines <= 60; ++lines) {
        for (u32 columns = 1; columns <= lines; ++columns) {
            ASSERT_EQ(first_line_of_column(0, lines, columns), 0u);
            ASSERT_EQ(first_line_of_column(columns, lines, columns), lines);
            for (u32 column = 0; column < columns; ++column) {
                const u32 begin = first_line_of_column(column, lines, columns);
                const u32 end = first_line_of_column(column + 1, lines, columns);
                ASSERT_GE(end - begin, lines / columns);
                ASSERT_LE(end - begin, lines / columns + 1);
                for (u32 line = begin; line < end; ++line)
                    ASSERT_EQ(column_of_line(line, lines, columns), column);
            }
        }
    }
}

TEST(Column, HoldsForTheMostLines) {
    const u32 lines = 1u << 30;
    const u32 columns = lines / 3;
    EXPECT_EQ(column_of_line(lines - 1, lines, columns), columns - 1);
    EXPECT_EQ(first_line_of_column(columns, lines, columns), lines);
}

TEST(Column, HasEachNeighbourOnce) {
    for (u32 columns = 1; columns <= 6; ++columns) {
        for (const u32 wraps : {0u, 1u}) {
            for (u32 column = 0; column < columns; ++column) {
                std::set<u32> expected{column};
                if (column > 0 || wraps != 0) expected.insert((column + columns - 1) % columns);
                if (column + 1 < columns || wraps != 0) expected.insert((column + 1) % columns);

                std::multiset<u32> got;
                const u32 first = first_neighbour(column, columns, wraps);
                for (u32 i = 0; i < neighbour_count(column, columns, wraps); ++i)
                    got.insert((first + i) % columns);
                ASSERT_EQ(got, std::multiset<u32>(expected.begin(), expected.end()))
                    << column << " of " << columns << (wraps != 0 ? ", torus" : ", box");
            }
        }
    }
}

TEST(Bucket, AscendsWithYAndUsesAtLeastHalfOfWhatThereIs) {
    for (const u32 height : {1u, 2u, 3u, 64u, 1'000'003u, 1u << 30, (1u << 30) + 1, 1u << 31}) {
        for (const u32 count : {1u, 2u, 7u, 1000u, 1u << 25}) {
            u32 last = 0;
            for (u32 k = 0; k < 1000; ++k) {
                const u32 y = to_u32(u64{height - 1} * k / 999);
                const u32 bucket = bucket_of(y, count, height);
                ASSERT_GE(bucket, last) << y << " of " << height << ", " << count << " buckets";
                ASSERT_LT(bucket, count);
                last = bucket;
            }
            EXPECT_EQ(bucket_of(0, count, height), 0u);
            // Where there are as many heights as buckets.
            EXPECT_TRUE(height < count || 2 * (last + 1) >= count) << height << ", " << count;
        }
    }
}

TEST(Near, HoldsAllLinesWithinReachOnce) {
    for (u32 lines = 1; lines <= 20; ++lines) {
        for (u32 reach = 0; reach <= 2 * lines + 1; ++reach) {
            for (const u32 wraps : {0u, lines}) {
                for (u32 line = 0; line < lines; ++line) {
                    const Stretch run = near_lines(line, reach, lines, wraps);
                    std::multiset<u32> got, expected;
                    for (u32 i = 0; i < run.count; ++i) got.insert((run.first + i) % lines);
                    for (u32 other = 0; other < lines; ++other)
                        if (axis_distance(line, other, wraps) <= reach) expected.insert(other);
                    ASSERT_EQ(got, expected) << line << " of " << lines << ", reach " << reach
                                             << (wraps != 0 ? ", torus" : ", box");
                }
            }
        }
    }
}

TEST(Near, HoldsTheirColumnsOnce) {
    for (u32 lines = 1; lines <= 20; ++lines) {
        for (u32 columns = 1; columns <= lines; ++columns) {
            for (u32 first = 0; first < lines; ++first) {
                for (u32 count = 1; count <= lines; ++count) {
                    const Stretch run = near_columns({first, count}, lines, columns);
                    std::multiset<u32> got;
                    std::set<u32> expected;
                    for (u32 i = 0; i < run.count; ++i) got.insert((run.first + i) % columns);
                    for (u32 i = 0; i < count; ++i)
                        expected.insert(column_of_line((first + i) % lines, lines, columns));
                    ASSERT_EQ(got, std::multiset<u32>(expected.begin(), expected.end()))
                        << columns << " columns, " << count << " of " << lines << " lines from "
                        << first;
                }
            }
        }
    }
}

TEST(Near, HoldsForTheLargestUnits) {
    const u32 lines = 1u << 31;
    EXPECT_EQ(near_lines(0, 5, lines, lines).first, lines - 5);
    EXPECT_EQ(near_lines(lines - 1, ~0u, lines, lines).count, lines);
    EXPECT_EQ(near_lines(lines - 1, ~0u, lines, 0).count, lines);
    const Stretch columns = near_columns({lines - 5, 11}, lines, lines / 3);
    EXPECT_EQ(columns.first, lines / 3 - 2);
    EXPECT_EQ(columns.count, 4u);
}

TEST(Window, HoldsAllWithinReachAndNothingElse) {
    for (const u32 height : {1u, 2u, 7u, 20u}) {
        for (u32 radius = 1; radius <= height + 2; ++radius) {
            for (const u32 windows : {1u, 3u}) {
                for (u32 y = 0; y < height; ++y) {
                    for (u32 other = 0; other < height; ++other) {
                        bool seen = false;
                        for (u32 window = 0; window < windows; ++window)
                            seen = seen || (other >= window_low(window, y, radius, height) &&
                                            other <= window_high(window, y, radius, height));
                        const u32 period = windows == 3 ? height : 0;
                        ASSERT_EQ(seen, axis_distance(y, other, period) <= radius)
                            << other << " from " << y << ", radius " << radius << ", height "
                            << height << ", windows " << windows;
                    }
                }
            }
        }
    }
}

TEST(Window, HoldsForTheLargestUnits) {
    const u32 height = 1u << 31;
    EXPECT_EQ(window_high(0, height - 1, ~0u, height), ~0u);
    EXPECT_EQ(window_low(0, height - 1, ~0u, height), 0u);
    EXPECT_EQ(window_low(1, 0, 5, height), height - 5);
    EXPECT_EQ(window_high(2, height - 1, 5, height), 4u);
}

}  // namespace
