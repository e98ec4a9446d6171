// The run of near cells holds the same cells as the stretches that it is made of.
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "portable/sample_grid.h"

namespace {

using namespace lacuna::portable;

std::set<u32> by_stretches(u32 begin, u32 end, u32 radius, u32 length, u32 period, u32 side) {
    std::set<u32> cells;
    for (u32 window = 0; window < (period != 0 ? 3u : 1u); ++window) {
        const u32 high = near_high(window, begin, end, radius, length, side);
        for (u32 cell = near_low(window, begin, end, radius, length, side); cell <= high; ++cell)
            cells.insert(cell);
    }
    return cells;
}

std::set<u32> by_run(u32 begin, u32 end, u32 radius, u32 length, u32 period, u32 side) {
    const u32 count = count_grid(length, side);
    const GridStretch run = grid_stretch(begin, end, radius, length, period, side, count);
    std::set<u32> cells;
    for (u32 i = 0; i < run.count; ++i) cells.insert(nth_of_stretch(run, i, count));
    EXPECT_LE(run.count, cells.size() + 1) << "at most the first cell comes twice";
    return cells;
}

TEST(GridStretch, AreThoseOfTheStretches) {
    constexpr unsigned kSeed = 21;
    std::mt19937 random(kSeed);
    for (int i = 0; i < 200'000; ++i) {
        const u32 length = 1 + static_cast<u32>(random() % 60);
        const u32 begin = static_cast<u32>(random() % length);
        const u32 end = begin + 1 + static_cast<u32>(random() % (length - begin));
        const u32 radius = 1 + static_cast<u32>(random() % 40);
        const u32 side = 1 + static_cast<u32>(random() % 12);
        const u32 period = random() % 2 == 0 ? length : 0;
        ASSERT_EQ(by_run(begin, end, radius, length, period, side),
                  by_stretches(begin, end, radius, length, period, side))
            << "[" << begin << ", " << end << "), radius " << radius << ", length " << length
            << ", side " << side << (period != 0 ? ", wraps" : "") << ", seed " << kSeed;
    }
}

}  // namespace
