// Draws thrown in slabs get the statuses of draws thrown one after another.
#include "backends/cpu/darts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

#include "backends/cpu/state.h"
#include "backends/scenes.h"
#include "portable/distance.h"
#include "portable/status.h"

namespace lacuna::cpu {
namespace {

// A state with `count` candidates at random points, in random order, all undecided.
SpanState thrown_at(const Plan& plan, std::uint32_t count, tests::Chance chance) {
    SpanState state(plan);
    for (std::uint32_t column = 0; column < state.columns; ++column) set_free(state, column);
    std::vector<Draw> draws;
    for (const std::uint32_t order : chance.orders(count))
        draws.push_back({chance.below(plan.lines), chance.below(plan.height),
                         chance.below(plan.strip_width), order});
    std::sort(draws.begin(), draws.end(), [](const Draw& a, const Draw& b) {
        return a.bin != b.bin ? a.bin < b.bin : a.rank < b.rank;
    });
    state.begin_round(draws);
    for (std::uint32_t column = 0; column < state.columns; ++column) locate(state, draws, column);
    return state;
}

// Throws the darts with a thread for each slab.
void throw_all(SpanState& state, std::uint32_t slabs) {
    const auto count = static_cast<std::uint32_t>(state.candidates.size());
    Darts darts;
    // In two parts; the second one sees the samples of the first.
    for (const auto& [begin, end] : {std::pair{0u, count / 3}, std::pair{count / 3, count}}) {
        darts.begin(begin, end, slabs);
        {
            std::vector<std::jthread> threads;
            for (std::uint32_t slab = 0; slab < slabs; ++slab)
                threads.emplace_back([&, slab] { darts.throw_in(state, slab); });
        }
        darts.finish(state, [] {});
    }
}

// Decides candidates one after another; each is compared with all samples.
std::vector<std::uint32_t> expected_statuses(const SpanState& state) {
    const Plan& plan = state.plan;
    std::vector<std::uint32_t> statuses(state.candidates.size(), STATUS_REJECTED);
    std::vector<Candidate> samples;
    for (const std::uint32_t i : state.by_order) {
        const Candidate& candidate = state.candidates[i];
        const bool is_free = std::none_of(samples.begin(), samples.end(), [&](const Candidate& s) {
            return portable::are_closer(s.x, s.y, candidate.x, candidate.y, plan.period_x,
                                        plan.period_y, plan.radius_squared);
        });
        if (!is_free) continue;
        statuses[i] = STATUS_ADMITTED;
        samples.push_back(candidate);
    }
    return statuses;
}

void expect_samples_in_grid(const SpanState& state) {
    std::vector<Sample> expected(std::size_t{state.plan.grid().columns} * state.plan.grid().rows,
                                 {NO_SAMPLE, NO_SAMPLE});
    for (std::size_t i = 0; i < state.candidates.size(); ++i) {
        const auto [x, y] = Sample{state.candidates[i].x, state.candidates[i].y};
        if (state.statuses[i] == STATUS_ADMITTED)
            expected[std::size_t{x / state.plan.grid().side} * state.plan.grid().rows +
                     y / state.plan.grid().side] = {x, y};
    }
    std::vector<Sample> got;
    for (std::uint32_t i = 0; i < state.plan.grid().columns; ++i)
        got.insert(got.end(), state.grid->column(i),
                   state.grid->column(i) + state.plan.grid().rows);
    EXPECT_TRUE(got == expected) << "the grid holds other samples, or a mark";
}

TEST(Darts, InAnyNumberOfSlabsBecomeWhatTheyBecomeOneByOne) {
    for (const Boundary boundary : {Boundary::box, Boundary::torus}) {
        for (const auto& [radius, lines, height, draws] :
             {std::tuple{0.01, 6u, 1.0, 6'000u}, std::tuple{0.03, 1u, 0.2, 3'000u},
              std::tuple{0.02, 3u, 0.02, 500u}, std::tuple{0.2, 5u, 1.0, 2'000u},
              std::tuple{0.8, 2u, 1.0, 50u}}) {
            const Plan plan = tests::plan_of(radius, lines, boundary, 1, height, Mode::exact);
            for (const std::uint32_t slabs : {1u, 2u, 3u, 8u, 40u}) {
                SCOPED_TRACE(testing::Message() << "radius " << radius << ", slabs " << slabs);
                SpanState state = thrown_at(plan, draws, tests::Chance(draws));
                const std::vector<std::uint32_t> expected = expected_statuses(state);
                throw_all(state, slabs);
                EXPECT_EQ(state.statuses, expected);
                expect_samples_in_grid(state);
            }
        }
    }
}

}  // namespace
}  // namespace lacuna::cpu
