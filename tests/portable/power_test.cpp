// The arithmetic of relaxation: right at small numbers, and free of overflow at the largest
// allowed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>

#include "portable/power.h"

namespace power_test {

using namespace lacuna::portable;
__extension__ using Wide = unsigned __int128;
__extension__ using SignedWide = __int128;

constexpr u64 kMostPoints = u64{1} << 31;
constexpr u64 kMostMass = 65535 * kMostPoints;
constexpr u32 kMostOfSide = u32{1} << 21;
constexpr u32 kLongestStep = 511;
constexpr u64 kMostPointsTimesSide = u64{1} << 46;

Wide growth_of(Wide mass, Wide mean) {
    const Wide off = mass > mean ? mass - mean : mean - mass;
    return std::min<Wide>(std::min<Wide>(off * 37, mean * 32) * 512 / mass, MOST_GROWTH);
}

u64 random_below(std::mt19937_64& random, u64 end) {
    return (random() >> (random() % 60)) % end;
}

TEST(Power, growth_and_step_equal_those_of_128_bits) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 200000; ++i) {
        const u64 mass = i % 5 == 0 ? kMostMass : 1 + random_below(random, kMostMass);
        const u64 mean = i % 7 == 0 ? kMostMass : random_below(random, kMostMass);
        const u64 growth = weight_growth(mass, mean);
        ASSERT_EQ(growth, static_cast<u64>(growth_of(mass, mean))) << mass << " " << mean;
        const u32 points =
            static_cast<u32>(i % 3 == 0 ? kMostPoints : random_below(random, kMostPoints));
        const Wide step = Wide{growth} * points * kLongestStep / 256;
        ASSERT_EQ(weight_step(growth, points, 256, kLongestStep), static_cast<u64>(step));
    }
}

TEST(Power, growth_is_that_of_the_design) {
    // eta (mean - m) / (1.73 m) and eta mean / (2 m), eta = 1/2, in 65536ths.
    const auto formula = [](double m, double mean) {
        return 65536 * std::min(0.5 * std::abs(mean - m) / (1.73 * m), 0.5 * mean / (2 * m));
    };
    for (const double m : {700e3, 900e3, 999e3, 1001e3, 1.2e6, 1.9e6, 5e6, 3e8})
        EXPECT_NEAR(static_cast<double>(weight_growth(static_cast<u64>(m), 1000000)),
                    formula(m, 1e6), 1 + 0.0005 * formula(m, 1e6))
            << m;
    EXPECT_EQ(weight_growth(1000000, 1000000), 0u);
    EXPECT_EQ(weight_growth(1, 1000000), MOST_GROWTH);
    EXPECT_EQ(weight_growth(1, 0), 0u);
}

RelaxLattice largest_lattice() {
    RelaxLattice lattice{};
    lattice.farthest = squared_length(kMostOfSide * kLongestStep, kMostOfSide * kLongestStep);
    lattice.mean_mass = kMostMass / 2;
    lattice.lonely_step = kMostPoints * kLongestStep * 256 / 4 + 1;
    lattice.step_x = 256;
    lattice.step_y = kLongestStep;
    return lattice;
}

TEST(Power, weights_stay_between_zero_and_the_farthest_distance) {
    const RelaxLattice lattice = largest_lattice();
    EXPECT_LT(lattice.farthest, u64{1} << 61);
    for (const u64 weight : {u64{0}, lattice.farthest / 2, lattice.farthest})
        for (const u64 mass : {u64{0}, u64{1}, lattice.mean_mass, kMostMass})
            for (const u32 points : {0u, 1u, 0x80000000u})
                EXPECT_LE(moved_weight(lattice, weight, mass, points), lattice.farthest);
}

TEST(Power, a_weight_is_bounded_by_the_squared_distance_to_the_nearest_sample) {
    const u64 farthest = largest_lattice().farthest;
    const u64 even = even_weight(farthest);
    std::mt19937_64 random(3);
    for (int i = 0; i < 100000; ++i) {
        const u64 weight = i % 5 == 0 ? farthest : random_below(random, farthest + 1);
        const u64 reach = reach_of_weight(farthest, weight);
        const u64 nearest = std::min(random_below(random, farthest + 1), reach);
        const SignedWide part = SignedWide(nearest / 16) + 1;
        const SignedWide own = SignedWide(even) - SignedWide(weight);
        const SignedWide expected = std::clamp<SignedWide>(own, -5 * part, 10 * part);
        const u64 bounded = bounded_weight(farthest, weight, nearest);
        ASSERT_EQ(SignedWide(even) - SignedWide(bounded), expected) << weight << " " << nearest;
        ASSERT_LE(bounded, farthest);
        ASSERT_EQ(bounded_weight(farthest, bounded, nearest), bounded);
        ASSERT_EQ(bounded_weight(farthest, weight, reach), weight);
    }
}

// So no other sample wins the lattice points at a sample's own position.
TEST(Power, two_weights_differ_by_less_than_the_squared_distance_of_their_samples) {
    const u64 farthest = largest_lattice().farthest;
    for (u64 distance = 256; distance < u64{1} << 60; distance *= 3)
        EXPECT_LT(
            bounded_weight(farthest, farthest, distance) - bounded_weight(farthest, 0, distance),
            distance);
}

TEST(Power, a_move_is_a_part_of_the_way_and_stays_in_the_domain) {
    constexpr u32 kLength = kMostOfSide * kLongestStep;
    std::mt19937_64 random(4);
    for (int i = 0; i < 100000; ++i) {
        const u32 length = 1 + static_cast<u32>(random_below(random, kLength));
        const u32 at = static_cast<u32>(random() % length);
        const u32 centre = static_cast<u32>(random() % length);
        for (const u32 way : {WHOLE_WAY, LONG_WAY}) {
            const std::int64_t off = std::int64_t{centre} - at;
            const std::int64_t moved = at + off * way / 256;
            EXPECT_EQ(moved_place(at, centre, way, length, 0),
                      std::clamp<std::int64_t>(moved, 0, length - 1));
            const std::int64_t shortest =
                off - (2 * off > length                  ? length
                       : 2 * off < -std::int64_t{length} ? -std::int64_t{length}
                                                         : 0);
            const std::int64_t round = at + shortest * way / 256;
            EXPECT_EQ(moved_place(at, centre, way, length, length), (round + length) % length);
        }
        EXPECT_EQ(moved_place(at, centre, WHOLE_WAY, length, 0), centre);
        EXPECT_EQ(moved_place(at, centre, WHOLE_WAY, length, length), centre);
    }
}

TEST(Power, powers_stay_below_two_to_the_62) {
    const RelaxLattice lattice = largest_lattice();
    const u32 corner = kMostOfSide * kLongestStep - 1;
    EXPECT_LT(power_of(0, 0, corner, corner, lattice.farthest, 0, 0), u64{1} << 62);
}

// All lattice points of the largest lattice belong to one sample in a corner.
TEST(Power, sums_of_moments_do_not_overflow) {
    const u64 columns = kMostPointsTimesSide / kMostPoints;
    Wide offset = 0;
    for (u32 i = 0; i < columns; ++i)
        for (const u32 at : {0u, static_cast<u32>(columns) * 256 - 1})
            offset =
                std::max<Wide>(offset, moment_offset(i, at, 256, static_cast<u32>(columns), 0));
    EXPECT_LE(offset, 2 * columns);
    EXPECT_LT(Wide{65535} * kMostPoints * offset, Wide{1} << 63);
}

TEST(Power, offset_is_the_shortest_way_round) {
    for (u32 at = 0; at < 10 * 256; at += 37) {
        for (u32 index = 0; index < 10; ++index) {
            const int way = static_cast<int>(moment_offset(index, at, 256, 10, 2560)) - 10;
            const int place = static_cast<int>(at / 256) + way;
            EXPECT_EQ((place + 10) % 10, static_cast<int>(index));
            EXPECT_LE(std::abs(place * 256 + 128 - static_cast<int>(at)), 1280);
            EXPECT_EQ(moment_offset(index, at, 256, 10, 0), 10 + index - at / 256);
        }
    }
}

TEST(Power, centre_of_mass_is_the_nearest_unit) {
    std::mt19937_64 random(2);
    for (int i = 0; i < 100000; ++i) {
        const u32 count = 1 + static_cast<u32>(random_below(random, kMostOfSide));
        const u32 step = 256 + static_cast<u32>(random() % 256);
        const u32 at = static_cast<u32>(random() % (u64{count} * step));
        const u64 mass =
            1 + random_below(random, std::min(kMostMass, (u64{1} << 63) / (2 * u64{count})) - 1);
        // Between the first and the last lattice point, as seen from `at`.
        const u64 low = count - at / step;
        const u64 moment = mass * low + static_cast<u64>(Wide{random()} * (count - 1) * mass >> 64);
        const Wide twice = 2 * (Wide{moment} - Wide{mass} * low) * step;
        const u64 expected = static_cast<u64>((twice / mass + 1) / 2) + step / 2;
        const u64 got = centre_of_mass(moment, mass, at, step, count, 0);
        ASSERT_LE(got > expected ? got - expected : expected - got, 1u);
        const SignedWide error = SignedWide(got - step / 2) * mass * 2 - SignedWide(twice);
        ASSERT_LE(error < 0 ? -error : error, SignedWide(mass) + 1);
        ASSERT_LT(got, u64{count} * step);
        ASSERT_EQ(centre_of_mass(moment, mass, at, step, count, count * step), got);
    }
}

}  // namespace power_test
