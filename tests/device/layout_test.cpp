// How a plan is laid out in a device's memory.
#include "device/layout.h"

#include <gtest/gtest.h>

#include "backends/scenes.h"

namespace lacuna::device {
namespace {

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

TEST(NearBegins, LeaveRoomForAllDrawsNearAColumn) {
    std::vector<std::uint32_t> begins;
    const std::vector<std::uint32_t> column_begins = {0, 1, 11, 111, 1111};  // 1, 10, 100, 1000
    find_near_begins(tests::plan_of(0.2, 2, Boundary::torus), 4, column_begins, begins);
    EXPECT_EQ(begins, (std::vector<std::uint32_t>{0, 1011, 1122, 2232, 3333}));
    find_near_begins(tests::plan_of(0.2, 2, Boundary::box), 4, column_begins, begins);
    EXPECT_EQ(begins, (std::vector<std::uint32_t>{0, 11, 122, 1232, 2332}));
}

TEST(Requests, ThatDoNotFitAreRefusedWithWhatTheyNeed) {
    const Plan plan = tests::plan_of(0.001, 30, Boundary::torus);
    const std::uint64_t much = std::uint64_t{1} << 40;
    EXPECT_NO_THROW(refuse_if_too_large("Toy", plan, much, much));
    const auto refusal = [&](std::uint64_t memory, std::uint64_t buffer) -> std::string {
        try {
            refuse_if_too_large("Toy", plan, memory, buffer);
        } catch (const Unavailable& error) {
            return error.what();
        }
        return "";
    };
    // 30,000 lines with room for 508 spans of 8 bytes, and the draws.
    EXPECT_EQ(refusal(100'000'000, much),
              "device Toy: the request needs 0.145 GB of memory, and it has 0.1 GB");
    EXPECT_EQ(refusal(much, 1'000'000),
              "device Toy: the request needs a buffer of 0.006 GB, and its largest has 0.001 GB");
}

}  // namespace
}  // namespace lacuna::device
