// The run of near cells holds the cells of all units within the radius, and no others.
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "portable/distance.h"
#include "portable/stretch.h"

namespace {

using namespace lacuna::portable;

// The same cells, found unit by unit.
std::set<u32> by_units(u32 begin, u32 end, u32 radius, u32 length, u32 period, u32 side) {
    std::set<u32> cells;
    for (u32 unit = 0; unit < length; ++unit)
        for (u32 at = begin; at < end; ++at)
            if (axis_distance(unit, at, period) <= radius) cells.insert(unit / side);
    return cells;
}

std::set<u32> by_run(u32 begin, u32 end, u32 radius, u32 length, u32 period, u32 side) {
    const u32 count = (length - 1) / side + 1;
    const Stretch run = cells_near(begin, end, radius, length, period, side, count);
    std::set<u32> cells;
    for (u32 i = 0; i < run.count; ++i) cells.insert(nth_of_stretch(run, i, count));
    EXPECT_LE(run.count, cells.size() + 1) << "at most the first cell comes twice";
    return cells;
}

TEST(CellsNear, HoldsTheCellsOfAllUnitsWithinTheRadius) {
    constexpr unsigned kSeed = 21;
    std::mt19937 random(kSeed);
    for (int i = 0; i < 20'000; ++i) {
        const u32 length = 1 + static_cast<u32>(random() % 60);
        const u32 begin = static_cast<u32>(random() % length);
        const u32 end = begin + 1 + static_cast<u32>(random() % (length - begin));
        const u32 radius = 1 + static_cast<u32>(random() % 40);
        const u32 side = 1 + static_cast<u32>(random() % 12);
        const u32 period = random() % 2 == 0 ? length : 0;
        ASSERT_EQ(by_run(begin, end, radius, length, period, side),
                  by_units(begin, end, radius, length, period, side))
            << "[" << begin << ", " << end << "), radius " << radius << ", length " << length
            << ", side " << side << (period != 0 ? ", wraps" : "") << ", seed " << kSeed;
    }
}

}  // namespace
