// Draws thrown in slabs get the statuses of draws thrown one after another.
#include "backends/cpu/darts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

#include "backends/columns.h"
#include "backends/cpu/round_memory.h"
#include "backends/cpu/sample_grid.h"
#include "backends/scenes.h"
#include "portable/column.h"
#include "portable/distance.h"
#include "portable/status.h"

namespace lacuna::cpu {
namespace {

// A round of `count` candidates at random points, in random order, all undecided.
RoundMemory thrown_at(const Plan& plan, std::uint32_t count, tests::Chance chance) {
    RoundMemory round(plan, count_columns(plan));
    Snapshot scene;
    for (const std::uint32_t order : chance.orders(count))
        scene.candidates.push_back({chance.below(plan.width), chance.below(plan.height), 0, order});
    scene.statuses.assign(count, STATUS_UNDECIDED);
    round.restore(scene, [&](Candidate& candidate) {
        candidate.home = candidate.x / plan.strip_width;
        return portable::column_of_line(candidate.home, plan.lines, round.columns);
    });
    return round;
}

// Throws the darts with a thread for each slab.
void throw_all(SampleGrid& grid, RoundMemory& round, std::uint32_t slabs) {
    const std::uint32_t count = round.count();
    Darts darts;
    // In two parts; the second one sees the samples of the first.
    for (const auto& [begin, end] : {std::pair{0u, count / 3}, std::pair{count / 3, count}}) {
        darts.begin(begin, end, slabs);
        {
            std::vector<std::jthread> threads;
            for (std::uint32_t slab = 0; slab < slabs; ++slab)
                threads.emplace_back([&, slab] { darts.throw_in(grid, round, slab); });
        }
        darts.finish(grid, round, [] {});
    }
}

// Decides candidates one after another; each is compared with all samples.
std::vector<std::uint32_t> expected_statuses(const RoundMemory& round) {
    const Plan& plan = round.plan;
    std::vector<std::uint32_t> statuses(round.candidates.size(), STATUS_REJECTED);
    std::vector<Candidate> samples;
    for (const std::uint32_t i : round.by_order) {
        const Candidate& candidate = round.candidates[i];
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

void expect_samples_in_grid(const SampleGrid& grid, const RoundMemory& round) {
    std::vector<Sample> expected(std::size_t{round.plan.grid().columns} * round.plan.grid().rows,
                                 {NO_SAMPLE, NO_SAMPLE});
    for (std::size_t i = 0; i < round.candidates.size(); ++i) {
        const auto [x, y] = Sample{round.candidates[i].x, round.candidates[i].y};
        if (round.statuses[i] == STATUS_ADMITTED)
            expected[std::size_t{x / round.plan.grid().side} * round.plan.grid().rows +
                     y / round.plan.grid().side] = {x, y};
    }
    std::vector<Sample> got;
    for (std::uint32_t i = 0; i < round.plan.grid().columns; ++i)
        got.insert(got.end(), grid.column(i), grid.column(i) + round.plan.grid().rows);
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
                RoundMemory round = thrown_at(plan, draws, tests::Chance(draws));
                SampleGrid grid(plan);
                grid.clear(0, 1);
                const std::vector<std::uint32_t> expected = expected_statuses(round);
                throw_all(grid, round, slabs);
                EXPECT_EQ(round.statuses, expected);
                expect_samples_in_grid(grid, round);
            }
        }
    }
}

}  // namespace
}  // namespace lacuna::cpu
