// The arithmetic of the tree over sites: no site in a box breaks the box's bounds, and lags give
// the difference of two powers, within 32 bits where they claim it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <random>

#include "portable/power.h"
#include "portable/site_tree.h"

namespace {

using namespace lacuna::portable;
__extension__ using Wide = __int128;

constexpr std::int64_t kMostPlace = std::int64_t{1} << 30;
constexpr u64 kMostWeight = u64{1} << 61;

std::int64_t below(std::mt19937_64& random, std::int64_t end) {
    return static_cast<std::int64_t>((random() >> (random() % 60)) % static_cast<u64>(end));
}

struct Place {
    i32 x;
    i32 y;
};

Wide power(const Place& site, u64 weight, std::int64_t x, std::int64_t y) {
    const Wide dx = Wide{site.x} - x;
    const Wide dy = Wide{site.y} - y;
    return dx * dx + dy * dy + weight;
}

class SiteTree : public testing::Test {
protected:
    std::mt19937_64 random_{1};

    i32 place() { return static_cast<i32>(below(random_, kMostPlace)); }
    u64 weight() { return static_cast<u64>(below(random_, kMostWeight)); }
    Place site() { return {place(), place()}; }
    Rect rect(std::int64_t most_side) {
        const i32 left = place();
        const i32 bottom = place();
        return {left, bottom, left + static_cast<i32>(below(random_, most_side)),
                bottom + static_cast<i32>(below(random_, most_side))};
    }
    Place inside(const Rect& box) {
        return {box.left + static_cast<i32>(below(random_, box.right - box.left + 1)),
                box.bottom + static_cast<i32>(below(random_, box.top - box.bottom + 1))};
    }
};

TEST_F(SiteTree, a_nodes_least_power_is_that_of_its_nearest_place) {
    for (int i = 0; i < 100000; ++i) {
        const Rect node = rect(100000);
        const Rect box = rect(100000);
        const u64 least = weight();
        const u64 bound = least_power(node.left, node.bottom, node.right, node.top, least, box);
        const Place site = inside(node);
        const Place at = inside(box);
        ASSERT_LE(bound, power(site, least, at.x, at.y));
        const Place nearest{std::clamp(box.left, node.left, node.right),
                            std::clamp(box.bottom, node.bottom, node.top)};
        ASSERT_EQ(bound, power(nearest, least, std::clamp(nearest.x, box.left, box.right),
                               std::clamp(nearest.y, box.bottom, box.top)));
    }
}

TEST_F(SiteTree, a_sites_worst_power_is_that_in_its_worst_corner) {
    for (int i = 0; i < 100000; ++i) {
        const Rect box = rect(100000);
        const Place at = site();
        const u64 weighted = weight();
        Wide worst = 0;
        for (const i32 x : {box.left, box.right})
            for (const i32 y : {box.bottom, box.top})
                worst = std::max(worst, power(at, weighted, x, y));
        ASSERT_EQ(worst_power(at.x, at.y, weighted, box), worst);
    }
}

// Lags of two rivals near a tile, at the tile's lattice points.
class Lags : public SiteTree {
protected:
    static constexpr u32 kMost = 31;
    const u32 step_x_ = 256;
    const u32 step_y_ = 511;
    Rect box_{};
    Place site_{}, other_{};
    u64 weight_ = 0, other_weight_ = 0;

    Rival rival(const Place& at, u64 weighted) const {
        return rival_of(at.x - box_.left, at.y - box_.bottom, weighted);
    }
    Wide difference(u32 u, u32 v) const {
        const std::int64_t x = box_.left + std::int64_t{u} * step_x_;
        const std::int64_t y = box_.bottom + std::int64_t{v} * step_y_;
        return power(site_, weight_, x, y) - power(other_, other_weight_, x, y);
    }
    void draw() {
        box_ = rect(1);
        box_.right += static_cast<i32>(kMost * step_x_);
        box_.top += static_cast<i32>(kMost * step_y_);
        site_ = site();
        other_ = {std::clamp(site_.x + place() / 65536, 0, static_cast<i32>(kMostPlace - 1)),
                  std::clamp(site_.y - place() / 65536, 0, static_cast<i32>(kMostPlace - 1))};
        weight_ = weight();
        other_weight_ = std::min(weight_ + static_cast<u64>(below(random_, 1 << 30)), kMostWeight);
    }
};

TEST_F(Lags, are_differences_of_powers_in_all_lattice_points) {
    for (int i = 0; i < 20000; ++i) {
        draw();
        const Lag lag =
            lag_of(rival(site_, weight_), rival(other_, other_weight_), step_x_, step_y_);
        for (const u32 u : {0u, 7u, kMost})
            for (const u32 v : {0u, 12u, kMost})
                ASSERT_EQ(Wide{lag.at} + Wide{lag.along_x} * u + Wide{lag.along_y} * v,
                          difference(u, v));
    }
}

TEST_F(Lags, that_are_short_stay_below_2_to_the_29) {
    int shorts = 0;
    for (int i = 0; i < 200000; ++i) {
        draw();
        const Lag lag =
            lag_of(rival(site_, weight_), rival(other_, other_weight_), step_x_, step_y_);
        Wide worst = 0;
        for (const u32 u : {0u, kMost})
            for (const u32 v : {0u, kMost}) {
                const Wide value = difference(u, v);
                worst = std::max(worst, value < 0 ? -value : value);
            }
        if (!is_short(lag, kMost)) continue;
        ++shorts;
        ASSERT_LT(worst, Wide{1} << 29);
    }
    EXPECT_GT(shorts, 1000);
}

TEST_F(Lags, are_short_up_to_their_limit_and_no_further) {
    const std::int64_t limit = std::int64_t{1} << 29;
    EXPECT_TRUE(is_short({limit - 1, 0, 0}, 7));
    EXPECT_TRUE(is_short({1 - limit, 0, 0}, 7));
    EXPECT_FALSE(is_short({limit, 0, 0}, 7));
    EXPECT_FALSE(is_short({-limit, 0, 0}, 7));
    EXPECT_TRUE(is_short({0, (limit - 1) / 7, 0}, 7));
    EXPECT_FALSE(is_short({0, -(limit / 7 + 1), 0}, 7));
    EXPECT_FALSE(is_short({0, limit / 14 + 1, -(limit / 14 + 1)}, 7));
    EXPECT_FALSE(is_short({std::numeric_limits<std::int64_t>::max(), 1, 1}, 31));
}

TEST_F(Lags, tell_as_can_win_does_whether_one_fails_to_beat_the_other) {
    int wins = 0;
    for (int i = 0; i < 100000; ++i) {
        draw();
        Wide least = difference(0, 0);
        for (const u32 u : {0u, kMost})
            for (const u32 v : {0u, kMost}) least = std::min(least, difference(u, v));
        const bool can = can_win(rival(site_, weight_), rival(other_, other_weight_),
                                 kMost * step_x_, kMost * step_y_);
        ASSERT_EQ(can, least <= 0);
        wins += can ? 1 : 0;
    }
    EXPECT_GT(wins, 1000);
    EXPECT_LT(wins, 99000);
}

}  // namespace
