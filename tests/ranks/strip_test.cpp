// Strips divide a plan among ranks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include "backends/requests.h"
#include "plan/make_plan.h"
#include "plan/plan.h"
#include "ranks/strip.h"

namespace {

using namespace lacuna;

TEST(Strip, LinesAreSharedOutEvenlyAndEachOnce) {
    for (const Request& request : tests::equality_requests(Mode::exact)) {
        const Plan plan = make_plan(request);
        for (const std::uint32_t ranks : {1u, most_ranks(plan) / 2 + 1, most_ranks(plan)}) {
            if (ranks > most_ranks(plan)) continue;
            std::uint32_t next = 0;
            for (std::uint32_t rank = 0; rank < ranks; ++rank) {
                const Strip strip = strip_of(plan, rank, ranks);
                const Span own = strip.plan.own_lines();
                EXPECT_EQ(strip.first_line, next);
                EXPECT_LE(own.end - own.begin, plan.lines / ranks + 1);
                next += own.end - own.begin;
            }
            EXPECT_EQ(next, plan.lines);
        }
    }
}

TEST(Strip, IsTwoRadiiWideWithAHaloOfOneAndNoWiderThanTheDomain) {
    for (const Request& request : tests::equality_requests(Mode::exact)) {
        const Plan plan = make_plan(request);
        const std::uint32_t ranks = most_ranks(plan);
        for (std::uint32_t rank = 0; rank < ranks && ranks > 1; ++rank) {
            const Strip strip = strip_of(plan, rank, ranks);
            const Span own = strip.plan.own_x();
            EXPECT_GE(own.end - own.begin, 2 * plan.radius) << tests::describe(request);
            EXPECT_LE(strip.plan.width, plan.width) << tests::describe(request);
            const bool wraps = plan.period_x != 0;
            EXPECT_EQ(strip.has_low_neighbour(), wraps || rank > 0);
            EXPECT_EQ(strip.has_high_neighbour(), wraps || rank + 1 < ranks);
            if (strip.has_low_neighbour()) {
                EXPECT_GE(own.begin, plan.radius);
            }
            if (strip.has_high_neighbour()) {
                EXPECT_GE(strip.plan.width - own.end, plan.radius);
            }
        }
    }
}

TEST(Strip, SamplesLieWhereTheDomainHasThem) {
    Request request;
    request.radius = 0.01;
    request.domain.boundary = Boundary::torus;
    const Plan plan = make_plan(request);
    for (std::uint32_t rank = 0; rank < 5; ++rank) {
        const Strip strip = strip_of(plan, rank, 5);
        const std::uint32_t first = strip.plan.own_x().begin;
        const Sample lowest = strip.in_domain({first, 7});
        EXPECT_EQ(lowest.x, strip.first_line * plan.strip_width);
        EXPECT_EQ(lowest.y, 7u);
        EXPECT_LT(strip.in_domain({strip.plan.own_x().end - 1, 7}).x, plan.width);
    }
}

}  // namespace
