// The parts of a round that crowds: in order, with few draws in each column, and complete.
#include "backends/device/parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "backends/backend.h"

namespace parts_test {

using namespace lacuna;
using device::kMostOfColumn;
using device::PartLimits;

// As in mode cells, where columns are sorted.
const PartLimits kColumns{.of_column = kMostOfColumn};

TEST(Parts, OfFewDrawsAreOne) {
    const std::vector<std::uint32_t> begins = {0, kMostOfColumn, kMostOfColumn + 3};
    EXPECT_TRUE(device::is_one_part(begins, kColumns));
    const std::vector<std::uint32_t> one_more = {0, kMostOfColumn + 1, kMostOfColumn + 3};
    EXPECT_FALSE(device::is_one_part(one_more, kColumns));
    EXPECT_FALSE(device::is_one_part(begins, {kMostOfColumn + 2, 1u << 30}));
    EXPECT_FALSE(device::is_one_part(begins, {1u << 30, kMostOfColumn + 2}));
}

TEST(Parts, EndWhereAColumnHasNoMoreRoom) {
    std::vector<std::uint32_t> columns(2 * kMostOfColumn + 1, 1);
    EXPECT_EQ(device::find_part_ends(columns, 3, kColumns),
              (std::vector{kMostOfColumn, 2 * kMostOfColumn, 2 * kMostOfColumn + 1}));
    columns.front() = columns.back() = 2;
    EXPECT_EQ(device::find_part_ends(columns, 3, kColumns),
              (std::vector{kMostOfColumn + 1, 2 * kMostOfColumn + 1}));
}

TEST(Parts, HaveAsManyDrawsAsAllBeforeThemUpToTheMost) {
    const std::vector<std::uint32_t> columns(300, 0);
    EXPECT_EQ(device::find_part_ends(columns, 1, {20, 100}),
              (std::vector<std::uint32_t>{20, 40, 80, 160, 260, 300}));
}

TEST(Parts, ArrangeAllDrawsPartByPartAndColumnByColumn) {
    std::mt19937 random(5);
    const std::vector<std::uint32_t> begins = {0, 700, 700, 2000};
    std::vector<Draw> draws(2000);
    for (std::uint32_t i = 0; i < draws.size(); ++i) draws[i] = {i < 700 ? 0u : 2u, i, 0, i};
    std::shuffle(draws.begin(), draws.end(), random);
    for (std::uint32_t i = 0; i < draws.size(); ++i) {
        draws[i].bin = i < 700 ? 0 : 2;
        draws[i].rank = i;
    }
    const device::Arrangement made =
        device::arrange(std::span<const Draw>(draws), begins, kColumns);
    ASSERT_GE(made.ends.size(), 3u);
    EXPECT_EQ(made.ends.back(), draws.size());
    std::vector<bool> seen(draws.size(), false);
    std::uint32_t begin = 0;
    for (const std::uint32_t end : made.ends) {
        for (std::uint32_t i = begin; i < end; ++i) {
            const Draw& draw = draws[made.origins[i]];
            EXPECT_FALSE(seen[draw.rank]);
            seen[draw.rank] = true;
            EXPECT_GE(draw.order, begin);
            EXPECT_LT(draw.order, end);
            EXPECT_EQ(made.columns[i], draw.bin);
            if (i > begin) {
                EXPECT_LT(draws[made.origins[i - 1]].rank, draw.rank);
            }
        }
        begin = end;
    }
}

}  // namespace parts_test
