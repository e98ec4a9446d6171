// Ellipses in whole numbers: their chords hold what they hold, offset by offset, and the rounded
// ellipse of a pixel holds the true one.
#include "portable/ellipse.h"

#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "plan/ellipse.h"

namespace ellipse_test {

using namespace lacuna;
using namespace lacuna::portable;

using Random = std::mt19937_64;

double between(Random& random, double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random);
}

constexpr GridOfEllipses kUnits{1, 1, 1, 1e9};

lacuna::Ellipse any_radii(Random& random, double longest) {
    const double longer = between(random, 4, longest);
    return {longer, std::max(2.0, longer / std::exp(between(random, 0, 3))),
            between(random, -7, 7)};
}

TEST(AChordOfAnEllipse, HoldsWhatTheEllipseHolds) {
    Random random(3);
    std::uint64_t held = 0;
    for (int turn = 0; turn < 2000; ++turn) {
        const portable::Ellipse e = rounded(any_radii(random, 60), kUnits).ellipse;
        for (i64 dx = -64; dx <= 64; ++dx) {
            const Interval chord = chord_at(e, dx, 0);
            for (i64 dy = -64; dy <= 64; ++dy) {
                const bool is_held = holds(e, dx, dy);
                ASSERT_EQ(is_held, dy >= chord.begin && dy < chord.end)
                    << "turn " << turn << " at " << dx << " " << dy;
                ASSERT_EQ(is_held, holds(e, -dx, -dy)) << "it is the same from the other sample";
                held += is_held ? 1 : 0;
            }
        }
    }
    EXPECT_GT(held, 100'000U);
}

TEST(AChordOverColumns, IsHeldInEachOfThem) {
    Random random(4);
    std::uint64_t places = 0;
    for (int turn = 0; turn < 20'000; ++turn) {
        const portable::Ellipse e = rounded(any_radii(random, 1000), kUnits).ellipse;
        const auto middle = static_cast<i64>(between(random, -900, 900));
        const auto reach = static_cast<i64>(between(random, 0, 40));
        const Interval chord = chord_around(e, middle, reach);
        for (i64 dx = middle - reach; dx <= middle + reach && chord.begin < chord.end; ++dx) {
            ASSERT_TRUE(holds(e, dx, chord.begin)) << "turn " << turn << " at " << dx;
            ASSERT_TRUE(holds(e, dx, chord.end - 1)) << "turn " << turn << " at " << dx;
            ++places;
        }
    }
    EXPECT_GT(places, 20'000U);
}

// Every fifth rectangle reaches far beyond the ellipse.
TEST(AnEllipseThatMissesARectangle, HoldsNothingOfIt) {
    Random random(8);
    int missed = 0, reached = 0;
    constexpr int kTurns = 200'000;
    for (int turn = 0; turn < kTurns; ++turn) {
        const portable::Ellipse e = rounded(any_radii(random, 150), kUnits).ellipse;
        const double most = turn % 5 == 0 ? 600 : 60;
        const i64 left = static_cast<i64>(between(random, -200, 200));
        const i64 low = static_cast<i64>(between(random, -200, 200));
        const i64 right = left + static_cast<i64>(between(random, 0, most));
        const i64 high = low + static_cast<i64>(between(random, 0, most));
        bool is_held = false;
        for (i64 dx = left; dx <= right && !is_held; ++dx) {
            const Interval chord = chord_at(e, dx, 0);
            is_held = chord.begin < chord.end && chord.begin <= high && chord.end > low;
        }
        const bool is_missed = misses(e, left, right, low, high);
        ASSERT_FALSE(is_missed && is_held) << "turn " << turn;
        missed += is_missed ? 1 : 0;
        reached += is_held ? 1 : 0;
    }
    EXPECT_GT(reached, kTurns / 10);
    EXPECT_GT(missed, 97 * (kTurns - reached) / 100) << "most that is missed is told";
}

TEST(ACircleOfARadius, IsNotLarger) {
    Random random(5);
    for (int turn = 0; turn < 100'000; ++turn) {
        const auto radius = static_cast<u32>(2 + (random() >> (34 + random() % 29)));
        const portable::Ellipse circle = circle_of(radius);
        const double angle = between(random, 0, 7);
        const auto dx = std::llround(std::cos(angle) * radius);
        const auto dy = std::llround(std::sin(angle) * radius);
        if (dx * dx + dy * dy >= i64{radius} * radius) {
            ASSERT_FALSE(holds(circle, dx, dy)) << radius << ": " << dx << " " << dy;
        }
        ASSERT_TRUE(holds(circle, 0, i64{radius} - (radius >> 28) - 1)) << radius;
    }
}

// The rounded ellipse of radii from 2 units to more than the domain, on grids whose units are not
// square.
TEST(ARoundedEllipse, HoldsTheTrueOneAndLittleMore) {
    Random random(6);
    for (int turn = 0; turn < 200'000; ++turn) {
        const double shorter = std::exp2(between(random, 1, 29));
        const double ratio = std::exp(between(random, 0, std::log(turn % 2 == 0 ? 32 : 1000)));
        const double unit = std::exp(between(random, -20, 20));
        const GridOfEllipses grid{unit, unit * (1 + between(random, 0, 1e-7)), 1, 0x1p30};
        const lacuna::Ellipse radii{shorter * ratio * unit, shorter * unit, between(random, -7, 7)};
        const RoundedEllipse found = rounded(radii, grid);
        const QuadraticForm form = form_of(radii);
        // An offset near the true outline.
        const double around = between(random, 0, 7);
        const double share = between(random, 0.9, 1.1);
        const double along = share * radii.a * std::cos(around);
        const double across = share * radii.b * std::sin(around);
        const double c = std::cos(radii.angle), s = std::sin(radii.angle);
        const auto dx = std::llround((along * c - across * s) / grid.unit_x);
        const auto dy = std::llround((along * s + across * c) / grid.unit_y);
        if (std::max(std::abs(dx), std::abs(dy)) >= 1 << 30) continue;
        const double x = static_cast<double>(dx) * grid.unit_x;
        const double y = static_cast<double>(dy) * grid.unit_y;
        const double length = std::hypot(x, y) / unit;
        const bool is_held = holds(found.ellipse, dx, dy);
        if (length < 0x1p30 && form.holds(x, y)) {
            ASSERT_TRUE(is_held) << "turn " << turn;
        }
        // Two units and a share of 1e-5 farther out.
        const double larger = 1 + 2 / shorter + 1e-5;
        if (!form.holds(x / larger, y / larger)) {
            ASSERT_FALSE(is_held) << "turn " << turn << " ratio " << ratio;
        }
        if (length < found.inner) {
            ASSERT_TRUE(is_held) << "turn " << turn;
        }
        if (length >= found.outer && found.outer < grid.most) {
            ASSERT_FALSE(is_held) << "turn " << turn;
        }
    }
}

TEST(AWindow, CutsHeightsToTheDomain) {
    EXPECT_EQ(height_in_window(0, -3, 10), 0U);
    EXPECT_EQ(height_in_window(0, 4, 10), 4U);
    EXPECT_EQ(height_in_window(0, 13, 10), 10U);
    EXPECT_EQ(height_in_window(1, -3, 10), 7U);
    EXPECT_EQ(height_in_window(1, 4, 10), 10U);
    EXPECT_EQ(height_in_window(2, 13, 10), 3U);
    EXPECT_EQ(height_in_window(2, 4, 10), 0U);
}

}  // namespace ellipse_test
