// Columns and stretches against brute force: nothing within reach is ever left out or seen twice.
#include "portable/column.h"

#include <gtest/gtest.h>

#include <set>

#include "portable/distance.h"

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
                const Stretch near = stretch_around(column, 1, columns, wraps);
                for (u32 i = 0; i < near.count; ++i) got.insert(nth_of_stretch(near, i, columns));
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
            // If there are as many heights as buckets, at least half of the buckets are used.
            EXPECT_TRUE(height < count || 2 * (last + 1) >= count) << height << ", " << count;
        }
    }
}

TEST(Near, HoldsAllLinesWithinReachOnce) {
    for (u32 lines = 1; lines <= 20; ++lines) {
        for (u32 reach = 0; reach <= 2 * lines + 1; ++reach) {
            for (const u32 wraps : {0u, lines}) {
                for (u32 line = 0; line < lines; ++line) {
                    const Stretch run = stretch_around(line, reach, lines, wraps);
                    std::multiset<u32> got, expected;
                    for (u32 i = 0; i < run.count; ++i) got.insert(nth_of_stretch(run, i, lines));
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
                    const Stretch run = columns_of_stretch({first, count}, lines, columns);
                    std::multiset<u32> got;
                    std::set<u32> expected;
                    for (u32 i = 0; i < run.count; ++i) got.insert(nth_of_stretch(run, i, columns));
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
    EXPECT_EQ(stretch_around(0, 5, lines, lines).first, lines - 5);
    EXPECT_EQ(stretch_around(lines - 1, ~0u, lines, lines).count, lines);
    EXPECT_EQ(stretch_around(lines - 1, ~0u, lines, 0).count, lines);
    const Stretch columns = columns_of_stretch({lines - 5, 11}, lines, lines / 3);
    EXPECT_EQ(columns.first, lines / 3 - 2);
    EXPECT_EQ(columns.count, 4u);
}

}  // namespace
