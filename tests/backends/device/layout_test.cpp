// How a plan is laid out in a device's memory.
#include "backends/device/layout.h"

#include <gtest/gtest.h>

#include "backends/cells_scenes.h"
#include "backends/device/cells_layout.h"
#include "backends/radius_field_requests.h"

namespace lacuna::device {
namespace layout_test {

TEST(Slabs, HoldEveryLineOnceAndFit) {
    for (const std::uint32_t lines : {1u, 2u, 7u, 100u}) {
        for (const std::uint64_t largest :
             {std::uint64_t{1}, std::uint64_t{400}, ~std::uint64_t{0}}) {
            std::uint32_t next = 0;
            for (const Slab& slab : share_out(lines, 10, largest)) {
                EXPECT_EQ(slab.first_line, next);
                EXPECT_TRUE(slab.lines() == 1 ||
                            std::uint64_t{slab.lines()} * 10 * sizeof(Span) <= largest);
                next = slab.end_line;
            }
            EXPECT_EQ(next, lines);
        }
    }
    EXPECT_EQ(share_out(100, 10, 400).size(), 20u);
    EXPECT_EQ(share_out(100, 10, ~std::uint64_t{0}).size(), 1u);
}

TEST(Slabs, TakeTheDrawsOfTheirLines) {
    const std::vector<Draw> draws = {{2, 0, 0, 0}, {2, 0, 0, 1}, {5, 0, 0, 2}};
    EXPECT_EQ(draws_of({0, 2}, draws).end, 0u);
    const Range middle = draws_of({2, 5}, draws);
    EXPECT_EQ(middle.begin, 0u);
    EXPECT_EQ(middle.end, 2u);
    EXPECT_EQ(draws_of({5, 9}, draws).begin, 2u);
    EXPECT_EQ(draws_of({5, 9}, draws).end, 3u);
}

TEST(Tiles, CoverALineAndAreAtMostSoMany) {
    for (const double radius : {0.9, 0.3, 0.01, 0.001, 0.0001}) {
        for (const Mode mode : {Mode::lines, Mode::exact}) {
            const Plan plan = tests::plan_of(radius, 2, Boundary::torus, 1, 1, mode);
            const Tiles tiles = tiles_of(plan, 32);
            EXPECT_LE(tiles.count, kMostTiles);
            EXPECT_GE(std::uint64_t{tiles.count} * tiles.height, plan.height);
            EXPECT_LT((tiles.count - std::uint64_t{1}) * tiles.height, plan.height);
        }
    }
}

TEST(Tiles, DivideSpansAndJoinThemAgain) {
    const Tiles tiles{3, 100};
    Snapshot lines;
    lines.capacity = 4;
    lines.spans = {{{5, 7}, {90, 210}, {250, 260}}, {}, {{0, 100}, {101, 300}}};
    const Packed packed = pack({0, 3}, tiles, lines);
    EXPECT_EQ(packed.counts, (std::vector<std::uint32_t>{2, 1, 2, 0, 0, 0, 1, 1, 1}));
    EXPECT_EQ(packed.lengths, (std::vector<std::uint32_t>{12, 100, 20, 0, 0, 0, 100, 99, 100}));
    Snapshot joined;
    joined.capacity = lines.capacity;
    unpack({0, 3}, tiles, packed.slots, packed.counts, joined);
    lines.spans[2] = {{0, 100}, {101, 300}};
    EXPECT_TRUE(joined.spans == lines.spans);
}

TEST(SlicesOfSample, AreSoManyThatNoneTakesMoreTurns) {
    for (const tests::Scene& scene : tests::random_cells_scenes()) {
        const std::vector<std::uint32_t>& reaches = scene.plan.cells().radii->reaches;
        const std::uint32_t widest = *std::max_element(reaches.begin(), reaches.end());
        const std::uint64_t of_line = turns_of_line(scene.plan, widest);
        const std::uint64_t of_sample = turns_of_sample(scene.plan, widest);
        const std::uint64_t lines = of_sample / of_line;
        EXPECT_EQ(slices_of_sample(scene.plan, widest, of_sample), 1u) << scene.name;
        EXPECT_EQ(slices_of_sample(scene.plan, widest, 1), lines) << scene.name;
        for (const std::uint64_t most : {of_line, 3 * of_line, of_sample / 2 + of_line}) {
            const std::uint64_t slices = slices_of_sample(scene.plan, widest, most);
            EXPECT_LE((lines + slices - 1) / slices * of_line, most) << scene.name;
        }
    }
}

// The message of a device of this size that refuses the plan; empty if it does not.
std::string refusal(const Plan& plan, std::uint64_t memory, std::uint64_t buffer) {
    try {
        refuse_if_too_large("Toy", plan, memory, buffer);
    } catch (const Unavailable& error) {
        return error.what();
    }
    return "";
}

TEST(Requests, ThatDoNotFitAreRefusedWithWhatTheyNeed) {
    const Plan plan = tests::plan_of(0.001, 30, Boundary::torus);
    const std::uint64_t much = std::uint64_t{1} << 40;
    EXPECT_NO_THROW(refuse_if_too_large("Toy", plan, much, much));
    // 30,000 lines of 23 tiles, each with room for 31 spans of 8 bytes, the draws, and the cells.
    EXPECT_EQ(refusal(plan, 100'000'000, much),
              "device Toy: the request needs 0.235 GB of memory, and it has 0.1 GB");
    EXPECT_EQ(refusal(plan, much, 1'000'000),
              "device Toy: the request needs a buffer of 0.00828 GB, and its largest has 0.001 GB");
}

TEST(Requests, OfModeCellsThatDoNotFitAreRefusedToo) {
    // 10,000 lines of 314 words, 2 x 8 pixels, and the draws.
    const Field field = tests::constant_field(2, 8);
    const Plan plan = tests::cells_plan(field, 0.001, 10, Metric::min, Boundary::torus);
    const std::uint64_t much = std::uint64_t{1} << 40;
    EXPECT_NO_THROW(refuse_if_too_large("Toy", plan, much, much));
    EXPECT_EQ(refusal(plan, much, 12'000'000),
              "device Toy: the request needs a buffer of 0.0126 GB, and its largest has 0.012 GB");
    EXPECT_EQ(refusal(plan, 20'000'000, much),
              "device Toy: the request needs 0.0296 GB of memory, and it has 0.02 GB");
}

TEST(Requests, WithARadiusFieldThatDoNotFitAreRefusedToo) {
    // 696,500 samples with 2.5 boxes each, whose four strips have 8 bytes each: the largest buffer.
    const tests::FieldRequest made = tests::radius_field_request(
        "one pixel", tests::constant_field(1, 1), 696'500, Boundary::torus);
    const Plan plan = make_plan(made.request);
    const std::uint64_t much = std::uint64_t{1} << 40;
    EXPECT_NO_THROW(refuse_if_too_large("Toy", plan, much, 56'000'000));
    EXPECT_EQ(refusal(plan, much, 55'000'000),
              "device Toy: the request needs a buffer of 0.0557 GB, and its largest has 0.055 GB");
    EXPECT_EQ(refusal(plan, 200'000'000, much),
              "device Toy: the request needs 0.278 GB of memory, and it has 0.2 GB");
}

}  // namespace layout_test
}  // namespace lacuna::device
