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
