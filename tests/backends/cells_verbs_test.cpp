// Each verb of mode cells alone, on every parallel backend, against loops over all lattice points
// and all pairs of candidates, which use none of the backends' arithmetic.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <numeric>

#include "backends/available.h"
#include "backends/cells_scenes.h"
#include "backends/printing.h"

namespace lacuna {
namespace {

using tests::Scene;

// The squared distance in lattice steps.
std::uint64_t distance_squared(const Plan& plan, Sample a, Sample b) {
    const auto along = [](std::int64_t p, std::int64_t q, std::int64_t period) {
        const std::int64_t straight = std::abs(p - q);
        return period == 0 ? straight : std::min(straight, period - straight);
    };
    const std::int64_t dx = along(a.x, b.x, plan.period_x);
    const std::int64_t dy = along(a.y, b.y, plan.period_y);
    return static_cast<std::uint64_t>(dx * dx + dy * dy);
}

// Section 4.2.1, with radii in 1/256 of a step: distance < metric radius, both sides times 512.
bool conflict(const Plan& plan, Sample a, Sample b) {
    const std::uint64_t r = plan.cells().radii->radii[plan.cells().radii->pixel_at(a.x, a.y)];
    const std::uint64_t s = plan.cells().radii->radii[plan.cells().radii->pixel_at(b.x, b.y)];
    std::uint64_t twice = r + s;
    if (plan.cells().metric == Metric::min) twice = 2 * std::min(r, s);
    if (plan.cells().metric == Metric::max) twice = 2 * std::max(r, s);
    return 512 * 512 * distance_squared(plan, a, b) < twice * twice;
}

bool is_free(const Plan& plan, const Snapshot& memory, Sample at) {
    const std::size_t word = std::size_t{at.x} * tests::words_of_line(plan) + at.y / 32;
    return (memory.bits[word] >> at.y % 32 & 1) != 0;
}

// The memory that the verb should leave.
Snapshot located(const Scene& scene) {
    Snapshot after = scene.memory;
    std::vector<Candidate> candidates;
    for (const Draw& draw : scene.draws) {
        std::uint32_t left = draw.rank;
        std::uint32_t y = 0;
        while (!is_free(scene.plan, scene.memory, {draw.bin, y}) || left-- > 0) ++y;
        candidates.push_back({draw.bin, y, draw.bin, draw.order});
    }
    tests::set_candidates(scene.plan, candidates, after);
    return after;
}

// Decides the candidates one after the other, in the order of their draws.
Snapshot admitted(const Scene& scene) {
    Snapshot after = scene.memory;
    const std::vector<Candidate>& all = after.candidates;
    std::vector<std::size_t> by_order(all.size());
    std::iota(by_order.begin(), by_order.end(), std::size_t{0});
    std::sort(by_order.begin(), by_order.end(),
              [&](std::size_t a, std::size_t b) { return all[a].order < all[b].order; });
    std::vector<Sample> samples;
    for (const std::size_t i : by_order) {
        const Sample candidate = {all[i].x, all[i].y};
        const bool covered = std::any_of(samples.begin(), samples.end(), [&](Sample sample) {
            return conflict(scene.plan, sample, candidate);
        });
        after.statuses[i] = covered ? STATUS_REJECTED : STATUS_ADMITTED;
        if (!covered) samples.push_back(candidate);
    }
    return after;
}

Snapshot subtracted(const Scene& scene) {
    const Plan& plan = scene.plan;
    Snapshot after = scene.memory;
    for (std::size_t i = 0; i < after.candidates.size(); ++i) {
        if (after.statuses[i] != STATUS_ADMITTED) continue;
        const Sample sample = {after.candidates[i].x, after.candidates[i].y};
        for (std::uint32_t x = 0; x < plan.lines; ++x)
            for (std::uint32_t y = 0; y < plan.height; ++y)
                if (tests::has_importance(plan, x, y) && conflict(plan, sample, {x, y}))
                    after.bits[std::size_t{x} * tests::words_of_line(plan) + y / 32] &=
                        ~(1u << y % 32);
    }
    return after;
}

// Names the first lattice point whose bit differs.
testing::AssertionResult same_bits(const Plan& plan, const Snapshot& expected,
                                   const Snapshot& got) {
    if (expected.bits.size() != got.bits.size())
        return testing::AssertionFailure()
               << expected.bits.size() << " words expected, got " << got.bits.size();
    for (std::size_t i = 0; i < expected.bits.size(); ++i) {
        const std::uint32_t wrong = expected.bits[i] ^ got.bits[i];
        if (wrong == 0) continue;
        const auto bit = static_cast<std::size_t>(std::countr_zero(wrong));
        const std::size_t words = tests::words_of_line(plan);
        return testing::AssertionFailure()
               << "line " << i / words << ", y " << i % words * 32 + bit << ": expected to be "
               << ((expected.bits[i] >> bit & 1) != 0 ? "free" : "blocked");
    }
    return testing::AssertionSuccess();
}

void expect_left(const Scene& scene, const Snapshot& expected, Backend& backend) {
    SCOPED_TRACE(scene.name);
    const Snapshot got = backend.snapshot();
    EXPECT_EQ(expected.candidates, got.candidates);
    EXPECT_EQ(expected.statuses, got.statuses);
    EXPECT_TRUE(same_bits(scene.plan, expected, got));
}

class CellsVerbs : public tests::OnBackend {
protected:
    static std::unique_ptr<Backend> backend_at(const Scene& scene) {
        std::unique_ptr<Backend> backend = tests::make_backend(GetParam(), scene.plan);
        backend->restore(scene.memory);
        return backend;
    }
};

TEST_P(CellsVerbs, LocateWalksToTheRankAmongFreeLatticePoints) {
    for (const Scene& scene : tests::random_cells_scenes()) {
        const auto backend = backend_at(scene);
        backend->locate(scene.draws);
        expect_left(scene, located(scene), *backend);
    }
}

TEST_P(CellsVerbs, AdmitKeepsWhatNoEarlierSampleBlocksByTheMetric) {
    for (const Scene& scene : tests::random_cells_scenes()) {
        const auto backend = backend_at(scene);
        backend->admit();
        const Snapshot expected = admitted(scene);
        expect_left(scene, expected, *backend);
        // Expects the samples in the order of their draws.
        std::vector<Sample> samples(expected.candidates.size(), {NO_SAMPLE, NO_SAMPLE});
        for (std::size_t i = 0; i < samples.size(); ++i)
            if (expected.statuses[i] == STATUS_ADMITTED)
                samples[expected.candidates[i].order] = {expected.candidates[i].x,
                                                         expected.candidates[i].y};
        std::erase(samples, Sample{NO_SAMPLE, NO_SAMPLE});
        const Round round = backend->finish_round();
        EXPECT_TRUE(
            std::equal(round.samples.begin(), round.samples.end(), samples.begin(), samples.end()))
            << scene.name;
    }
}

TEST_P(CellsVerbs, SubtractBlocksWhatFailsTheTwoWayCheck) {
    tests::Chance chance(31);
    for (Scene& scene : tests::random_cells_scenes()) {
        for (std::uint32_t& status : scene.memory.statuses)
            status = chance.one_in(4) ? STATUS_ADMITTED : STATUS_REJECTED;
        const auto backend = backend_at(scene);
        backend->subtract();
        const Snapshot expected = subtracted(scene);
        expect_left(scene, expected, *backend);
        const Round round = backend->finish_round();
        ASSERT_EQ(round.free_lengths.size(), scene.plan.lines);
        for (std::uint32_t line = 0; line < scene.plan.lines; ++line)
            ASSERT_EQ(round.free_lengths[line], tests::free_length_of(scene.plan, expected, line))
                << scene.name << ", line " << line;
    }
}

TEST_P(CellsVerbs, ARoundIsTheThreeOfThem) {
    for (Scene& scene : tests::random_cells_scenes()) {
        const auto backend = backend_at(scene);
        backend->locate(scene.draws);
        backend->admit();
        backend->subtract();
        scene.memory = located(scene);
        scene.memory = admitted(scene);
        expect_left(scene, subtracted(scene), *backend);
    }
}

TEST_P(CellsVerbs, ABackendStartsWithEveryLatticePointThatHasImportance) {
    for (const Scene& scene : tests::random_cells_scenes()) {
        const auto backend = tests::make_backend(GetParam(), scene.plan);
        backend->locate({});
        backend->admit();
        backend->subtract();
        EXPECT_TRUE(same_bits(scene.plan, tests::empty_memory(scene.plan), backend->snapshot()))
            << scene.name;
    }
}

// A long row of candidates, each of which conflicts only with the two beside it.
TEST_P(CellsVerbs, ChainsOfAnyDepthAreSettled) {
    constexpr std::uint32_t kLength = 999;
    for (const bool upwards : {true, false}) {
        const Field field = tests::constant_field(1, 1);
        const Plan plan = tests::cells_plan(field, 1, 5, Metric::min, Boundary::box, 1, 810);
        Scene scene{"a chain", plan, tests::empty_memory(plan), {}};
        std::vector<Candidate> candidates;
        for (std::uint32_t i = 0; i < kLength; ++i)
            candidates.push_back({2, 4 * i, 2, upwards ? i : kLength - 1 - i});
        tests::set_candidates(plan, candidates, scene.memory);
        const auto backend = backend_at(scene);
        backend->admit();
        std::vector<std::uint32_t> alternating;
        for (std::uint32_t i = 0; i < kLength; ++i)
            alternating.push_back(i % 2 == 0 ? STATUS_ADMITTED : STATUS_REJECTED);
        EXPECT_EQ(backend->snapshot().statuses, alternating);
    }
}

TEST_P(CellsVerbs, OfManyDrawsAtOnePlaceTheFirstIsAdmitted) {
    const Field field = tests::constant_field(1, 1);
    const Plan plan = tests::cells_plan(field, 0.1, 5, Metric::min, Boundary::torus);
    Scene scene{"one place", plan, tests::empty_memory(plan), {}};
    for (std::uint32_t order = 0; order < 1000; ++order)
        scene.draws.push_back({7, 33, 0, 999 - order});
    const auto backend = backend_at(scene);
    backend->locate(scene.draws);
    backend->admit();
    const Round round = backend->finish_round();
    ASSERT_EQ(round.samples.size(), 1u);
    EXPECT_EQ(round.samples[0], (Sample{7, 33}));
}

INSTANTIATE_TEST_SUITE_P(Backend, CellsVerbs, tests::kParallelBackends, tests::name_of_parameter);

}  // namespace
}  // namespace lacuna
