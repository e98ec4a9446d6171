// Radius fields: where pixels lie in whole numbers, the radii under a rectangle, and the first
// boxes.
#include "plan/radius_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <vector>

#include "backends/radius_field_requests.h"
#include "plan/class_copies.h"
#include "plan/first_boxes.h"
#include "plan/make_plan.h"
#include "plan/plan.h"

namespace {

using namespace lacuna;

TEST(PixelAxis, CutsItsLengthIntoPixelsToAUnit) {
    for (const std::uint32_t length : {1u << 30, 1073741u, 805306368u, 1u << 20}) {
        for (const std::uint32_t pixels : {1u, 2u, 3u, 1000u, 4097u, 100000u}) {
            const PixelAxis axis(length, pixels);
            EXPECT_EQ(axis.begin_of(0), 0u);
            EXPECT_EQ(axis.begin_of(pixels), length);
            for (std::uint32_t pixel = 0; pixel < pixels; pixel += 1 + pixels / 97) {
                const std::uint32_t begin = axis.begin_of(pixel);
                EXPECT_NEAR(begin, static_cast<double>(pixel) * length / pixels, 1.0);
                EXPECT_EQ(axis.pixel_of(begin), pixel);
                EXPECT_EQ(axis.pixel_of(axis.begin_of(pixel + 1) - 1), pixel);
            }
        }
    }
}

// docs/exact.md, "Why the set is maximal".
TEST(ClassCopies, RoundDistancesUpByOneAndAHalfUnitsAtMost) {
    std::mt19937_64 random(8);
    const auto in = [&](double low, double high) {
        return low + (high - low) * std::generate_canonical<double, 53>(random);
    };
    for (int turn = 0; turn < 20000; ++turn) {
        const double ratio = 1 + std::pow(10, in(-10, 3.6));
        const auto radius = static_cast<std::uint32_t>(std::pow(2, in(9, 30)) / ratio) + 1;
        const std::vector distances{1.0, 0.0, 0.0, ratio};
        const ClassCopies copies(2, distances, std::vector{1.0, 1.0}, radius);
        EXPECT_EQ(portable::times_factor(radius, copies.factor(0, 0)), radius);
        EXPECT_EQ(copies.factor(0, 1), 0U);
        const double exact = radius * ratio;
        const auto rounded =
            static_cast<double>(portable::times_factor(radius, copies.factor(1, 1)));
        ASSERT_GE(rounded, exact * (1 - 0x1p-50)) << radius << " times " << ratio;
        ASSERT_LT(rounded, exact + 1.5001) << radius << " times " << ratio;
    }
}

// Looks at the radii of [x, x + width) times [begin, end) unit by unit, in fields of few units.
TEST(ARadiusField, TellsTheLeastAndTheGreatestRadiusUnderARectangle) {
    std::mt19937 random(5);
    const auto below = [&](std::uint32_t end) {
        return static_cast<std::uint32_t>(random() % end);
    };
    for (int turn = 0; turn < 20; ++turn) {
        const Field field = tests::noise_field(1 + below(9), 1 + below(9), random());
        const Mask mask = tests::noise_mask(1 + below(9), 1 + below(9), random());
        const std::uint32_t side = 60;
        const RadiusField radius_field(&field, 5, turn % 2 == 0 ? &mask : nullptr,
                                       {side, side, 1.0, 1.0, 0, side, 0, side, false});
        for (int k = 0; k < 50; ++k) {
            const std::uint32_t x = below(side);
            const std::uint32_t begin = below(side);
            const Box box{x, 1 + below(std::min(9u, side - x)), begin,
                          begin + 1 + below(std::min(9u, side - begin))};
            std::uint32_t least = ~0u;
            std::uint32_t greatest = 0;
            bool is_even = true;
            for (std::uint32_t i = x; i < x + box.width; ++i) {
                for (std::uint32_t j = begin; j < box.end; ++j) {
                    const std::uint32_t radius = radius_field.radius_at(i, j);
                    is_even = is_even && radius == radius_field.radius_at(x, begin);
                    if (radius == 0) continue;
                    least = std::min(least, radius);
                    greatest = std::max(greatest, radius);
                }
            }
            const Under under = radius_field.under(box);
            if (greatest == 0) continue;  // other pixels may then count
            EXPECT_LE(under.least, least);
            EXPECT_NE(under.least, 0u);
            EXPECT_GE(under.greatest, greatest);
            if (under.is_even) {
                EXPECT_TRUE(is_even);
                EXPECT_EQ(under.least, least);
            }
        }
    }
}

TEST(FirstBoxes, HoldAllThatIsAllowedOnce) {
    for (const tests::FieldRequest& made : tests::radius_field_requests()) {
        SCOPED_TRACE(made.name);
        const Plan plan = make_plan(made.request);
        const FirstBoxes& first = *plan.field().first_boxes;
        ASSERT_EQ(first.begins.size(), first.regions.size() + 1);
        ASSERT_EQ(first.begins.back(), first.boxes.size());
        std::mt19937 random(7);
        const auto below = [&](std::uint32_t end) {
            return static_cast<std::uint32_t>(random() % end);
        };
        for (int k = 0; k < 200; ++k) {
            const std::uint32_t x = below(plan.width);
            const std::uint32_t y = below(plan.height);
            const RadiusField::Shape& shape = plan.field().radius_field->shape();
            const bool is_allowed = plan.field().radius_field->radius_at(x, y) != 0 &&
                                    x >= shape.low_x && x < shape.high_x && y >= shape.low_y &&
                                    y < shape.high_y;
            const auto holders = std::count_if(
                first.boxes.begin(), first.boxes.end(),
                [&](const Box& p) { return x - p.x < p.width && y >= p.begin && y < p.end; });
            EXPECT_LE(holders, 1);
            if (is_allowed) {
                EXPECT_EQ(holders, 1);
            }
        }
        for (const Box& box : first.boxes) {
            const std::uint64_t longer = std::max(box.width, box.end - box.begin);
            EXPECT_TRUE(longer == 1 ||
                        longer * plan.lines_per_radius <=
                            2 * std::uint64_t{plan.field().radius_field->under(box).least});
        }
    }
}

TEST(FirstBoxes, LieInBlocksOfAFew) {
    std::size_t boxes = 0;
    std::size_t blocks = 0;
    for (const tests::FieldRequest& made : tests::radius_field_requests()) {
        SCOPED_TRACE(made.name);
        const Plan plan = make_plan(made.request);
        const FirstBoxes& first = *plan.field().first_boxes;
        boxes += first.boxes.size();
        blocks += first.block_count();
        EXPECT_EQ(first.blocks.front().first, 0u);
        EXPECT_EQ(first.blocks.back().first, first.boxes.size());
        for (std::uint32_t i = 0; i < first.block_count(); ++i) {
            const FirstBoxes::Block& block = first.blocks[i];
            const FirstBoxes::Node& node = first.nodes[block.node];
            const Box& all = node.box;
            EXPECT_EQ(node.first, i);
            EXPECT_EQ(node.next, block.node + 1);
            ASSERT_LT(block.first, first.blocks[i + 1].first);
            const Under under = plan.field().radius_field->under(all);
            EXPECT_EQ(block.even_radius, under.is_even ? under.least : 0u);
            EXPECT_EQ(node.greatest, under.greatest);
            for (std::uint32_t k = block.first; k < first.blocks[i + 1].first; ++k) {
                const Box& box = first.boxes[k];
                EXPECT_TRUE(box.x >= all.x && box.x + box.width <= all.x + all.width &&
                            box.begin >= all.begin && box.end <= all.end);
            }
            const std::uint64_t longer = std::max(all.width, all.end - all.begin);
            EXPECT_TRUE(longer == 1 || longer <= 6 * std::uint64_t{under.least});
        }
    }
    EXPECT_LT(2 * blocks, boxes);
}

}  // namespace
