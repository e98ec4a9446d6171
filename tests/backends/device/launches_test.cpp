// How kernels are launched: a few times a round, long work in slices, and cancelled in between.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "backends/available.h"
#include "backends/cells_scenes.h"
#include "backends/columns.h"
#include "backends/device/altered.h"
#include "backends/scenes.h"

namespace lacuna {
namespace {

class Launches : public tests::OnBackend {
protected:
    Outcome run(const Plan& plan, const device::Tuning& tuning = {}) {
        const auto backend = tests::make_backend(GetParam(), plan, tuning);
        Outcome outcome = tests::run_rounds(plan, *backend, 1000);
        launches_ = backend->work().launches;
        return outcome;
    }

    std::uint64_t launches_ = 0;
    const Plan lines_ = tests::plan_of(0.03, 6, Boundary::torus);
    const Plan exact_ = tests::plan_of(0.03, 6, Boundary::torus, 1, 1, Mode::exact);
    const Plan cells_ =
        tests::cells_plan(tests::noise_field(40, 30, 5), 0.02, 5, Metric::mean, Boundary::torus);
};

INSTANTIATE_TEST_SUITE_P(Device, Launches, tests::kDeviceBackends, tests::name_of_parameter);

TEST_P(Launches, AreAFewARoundNeverOneASample) {
    // A round has locate, screen, four passes, insert, collect, subtract, sum_tiles, and five to
    // list the samples. The start has some more.
    Outcome outcome = run(lines_);
    EXPECT_TRUE(outcome.samples == tests::run_on_cpu(lines_).samples);
    EXPECT_GE(launches_, 12 * outcome.rounds);
    EXPECT_LE(launches_, 16 * outcome.rounds + 10);
    // A refinement has cut and keep instead of collect, subtract and sum_tiles.
    outcome = run(exact_);
    EXPECT_TRUE(outcome.samples == tests::run_on_cpu(exact_).samples);
    EXPECT_GE(launches_, 14 * outcome.rounds);
    EXPECT_LE(launches_, 18 * outcome.rounds + 10);
    // locate, sort_columns, look_up_radii, four passes, subtract, subtract for long reaches, and
    // five to list the samples.
    outcome = run(cells_);
    EXPECT_TRUE(outcome.samples == tests::run_on_cpu(cells_).samples);
    EXPECT_GE(launches_, 12 * outcome.rounds);
    EXPECT_LE(launches_, 18 * outcome.rounds);
}

TEST_P(Launches, ShareTheLinesNearASampleOutAsTheyAreTold) {
    const std::vector<Sample> right = tests::run_on_cpu(cells_).samples;
    for (const std::uint32_t slices : {1u, 2u, 3u, 64u, 10'000u})
        EXPECT_TRUE(run(cells_, {0, 0, slices}).samples == right) << slices;
}

TEST_P(Launches, MakeTheSameSetFromManySlabs) {
    for (const Plan& plan : {lines_, exact_}) {
        const std::vector<Sample> right = tests::run_on_cpu(plan).samples;
        const device::Tiles tiles = device::tiles_of(plan, 32);
        const std::uint32_t spans = device::first_tile_capacity(plan, tiles) * tiles.count;
        const std::uint64_t line_bytes = spans * sizeof(Span);
        for (const std::uint64_t lines : {1u, 7u, 100u, plan.lines - 1}) {
            ASSERT_GT(device::share_out(plan.lines, spans, lines * line_bytes).size(), 1u);
            EXPECT_TRUE(run(plan, {lines * line_bytes, 32, 0}).samples == right) << lines;
        }
    }
}

// Rounds large enough that launches are sliced.
class LongLaunches : public tests::OnBackend {
protected:
    static constexpr std::uint32_t kDraws = 400'000;

    LongLaunches() {
        tests::Chance chance(31);
        draws_ = tests::random_draws(plan_, tests::empty_memory(plan_), chance, kDraws);
    }

    const Plan plan_ = tests::plan_of(0.001, 2, Boundary::torus, 1, 1, Mode::exact);
    std::vector<Draw> draws_;
};

INSTANTIATE_TEST_SUITE_P(Device, LongLaunches, tests::kDeviceBackends, tests::name_of_parameter);

struct Left {
    std::vector<Sample> samples;
    std::vector<Box> boxes;
};

Left after_two_rounds(Backend& backend, const std::vector<Draw>& draws) {
    backend.locate(draws);
    backend.admit();
    backend.subtract();
    const Round round = backend.finish_round();
    Left left{{round.samples.begin(), round.samples.end()}, {}};
    backend.locate({});
    backend.admit();
    backend.refine(true);
    left.boxes = backend.snapshot().boxes;
    return left;
}

TEST_P(LongLaunches, LeaveWhatTheCpuLeaves) {
    const auto backend = tests::make_backend(GetParam(), plan_);
    const Left expected = after_two_rounds(*tests::make_backend("cpu", plan_), draws_);
    const Left got = after_two_rounds(*backend, draws_);
    EXPECT_GT(expected.boxes.size(), 100'000u);
    EXPECT_TRUE(expected.samples == got.samples);
    EXPECT_TRUE(expected.boxes == got.boxes);
    // With one slice a launch, a round has 14 launches, a refinement 21, and the start a few.
    EXPECT_GT(backend->work().launches, 14u * 2 + 21 + 10);
}

TEST_P(LongLaunches, CanBeCancelledInBetweenAndTakenUpAgain) {
    const auto locate = [&](Backend& backend) {
        backend.time_verbs();
        backend.locate(draws_);
    };
    const auto backend = tests::make_backend(GetParam(), plan_);
    int asked = 0;
    backend->watch([&] { return ++asked > 0; });
    locate(*backend);
    const int asked_by_locate = asked;
    EXPECT_GE(asked_by_locate, 1);
    for (int allowed = 0; allowed < asked_by_locate; ++allowed) {
        asked = 0;
        const auto cancelled = tests::make_backend(GetParam(), plan_);
        cancelled->watch([&] { return ++asked <= allowed; });
        EXPECT_THROW(locate(*cancelled), Cancelled) << allowed;
        EXPECT_EQ(asked, allowed + 1);
    }
}

TEST_P(LongLaunches, CanBeCancelledInTheMidstOfASubtractionInCells) {
    const Field field = tests::constant_field(1, 1);
    const Plan plan = tests::cells_plan(field, 0.002, 10, Metric::min, Boundary::torus);
    tests::Chance chance(31);
    const std::vector<Draw> draws =
        tests::random_draws(plan, tests::empty_memory(plan), chance, 100'000);
    const auto backend = tests::make_backend(GetParam(), plan);
    int asked = 0;
    backend->time_verbs();
    backend->locate(draws);
    backend->admit();
    backend->watch([&] { return ++asked <= 1; });
    EXPECT_THROW(backend->subtract(), Cancelled);
    EXPECT_EQ(asked, 2);
}

}  // namespace
}  // namespace lacuna
