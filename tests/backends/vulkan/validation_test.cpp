// The backend under Vulkan's validation layer; and misuse, planted, to show that the layer is
// heard.
#include <gtest/gtest.h>

#include <mutex>
#include <string>
#include <vector>

#include "backends/available.h"
#include "backends/cells_requests.h"
#include "backends/cells_scenes.h"
#include "backends/columns.h"
#include "backends/vulkan/engine.h"
#include "backends/vulkan/make_backend.h"
#include "generate.h"
#include "portable/fate.h"

namespace {

using namespace lacuna;
using vulkan::Buffer;
using vulkan::Checks;
using vulkan::Engine;

class Validated : public testing::TestWithParam<Checks> {
protected:
    void SetUp() override {
        tests::skip_or_fail_without("vulkan");
        if (IsSkipped() || HasFatalFailure()) return;
        try {
            const Engine engine("", &validation_);
        } catch (const Unavailable& reason) {
            if (tests::is_required("vulkan")) FAIL() << reason.what();
            GTEST_SKIP() << reason.what();
        }
        EXPECT_EQ(messages(), "");
    }

    std::string messages() {
        const std::lock_guard lock(mutex_);
        return messages_;
    }

    std::mutex mutex_;
    std::string messages_;
    const vulkan::Validation validation_{GetParam(), [this](const std::string& message) {
                                             const std::lock_guard lock(mutex_);
                                             messages_ += message + "\n";
                                         }};
};

std::string name_of_checks(const testing::TestParamInfo<Checks>& info) {
    return info.param == Checks::gpu_assisted ? "gpu_assisted" : "core_and_synchronization";
}

using ValidatedAnyhow = Validated;
INSTANTIATE_TEST_SUITE_P(Vulkan, ValidatedAnyhow,
                         testing::Values(Checks::core_and_synchronization, Checks::gpu_assisted),
                         name_of_checks);

TEST_P(ValidatedAnyhow, MakesSetsWithoutAMessage) {
    for (const Mode mode : {Mode::lines, Mode::exact}) {
        for (const Boundary boundary : {Boundary::torus, Boundary::box}) {
            Request request;
            request.mode = mode;
            request.radius = 0.07;
            request.boundary = boundary;
            const Plan plan = make_plan(request);
            vulkan::Trial trial;
            trial.validation = &validation_;
            const device::Tuning tuning{std::uint64_t{100} * first_capacity(plan) * sizeof(Span)};
            Observer nobody;
            EXPECT_FALSE(generate(plan, *vulkan::make_backend(plan, {}, tuning, trial), nobody)
                             .samples.empty());
        }
    }
    EXPECT_EQ(messages(), "");
}

TEST_P(ValidatedAnyhow, MakesRoomForBoxesWithoutAMessage) {
    Request request;
    request.radius = 0.02;
    const Plan plan = make_plan(request);
    vulkan::Trial trial;
    trial.validation = &validation_;
    Snapshot scene;
    scene.capacity = 1;
    scene.grid.assign(std::size_t{plan.grid_columns} * plan.grid_rows, {NO_SAMPLE, NO_SAMPLE});
    scene.box_width = plan.strip_width;
    for (std::uint32_t y = 0; y < 2000; ++y) scene.boxes.push_back({0, 2 * y, 2 * y + 1});
    const auto backend = vulkan::make_backend(plan, {}, {}, trial);

    backend->restore(scene);
    backend->refine(true);

    EXPECT_EQ(backend->finish_round().free_lengths.size(), 4000u);
    EXPECT_EQ(messages(), "");
}

TEST_P(ValidatedAnyhow, GrowsAndTakesMorePassesWithoutAMessage) {
    // Each candidate is covered by the next one only, which is earlier: one is settled after the
    // other, in more passes than a round has. And there is room for one span a line.
    Request request;
    request.radius = 0.02;
    request.mode = Mode::lines;
    const Plan plan = make_plan(request);
    vulkan::Trial trial;
    trial.validation = &validation_;
    Snapshot scene;
    scene.capacity = 1;
    for (std::uint32_t line = 0; line < plan.lines; ++line)
        scene.spans.push_back({{0, plan.height}});
    const std::uint32_t line = plan.lines / 2;
    constexpr std::uint32_t kChain = 40;
    for (std::uint32_t i = 0; i < kChain; ++i)
        scene.candidates.push_back(
            {plan.centre_of_line(line), (i + 1) * (plan.radius - 1), line, kChain - 1 - i});
    scene.fates.assign(scene.candidates.size(), 0);
    const auto backend = vulkan::make_backend(plan, {}, {}, trial);

    backend->restore(scene);
    backend->admit();
    backend->subtract();
    const std::size_t admitted = backend->finish_round().samples.size();

    EXPECT_EQ(admitted, kChain / 2);
    EXPECT_GT(backend->snapshot().capacity, 1u);
    EXPECT_EQ(messages(), "");
}

TEST_P(ValidatedAnyhow, MakesSetsInCellsWithoutAMessage) {
    for (const Metric metric : {Metric::min, Metric::max}) {
        for (const Boundary boundary : {Boundary::torus, Boundary::box}) {
            const tests::CellsRequest made = tests::cells_request(
                "noise", tests::noise_field(30, 40, 3), 150, 8, metric, boundary, 1, 0.7);
            const Plan plan = make_plan(made.request);
            vulkan::Trial trial;
            trial.validation = &validation_;
            Observer nobody;
            EXPECT_FALSE(
                generate(plan, *vulkan::make_backend(plan, {}, {}, trial), nobody).samples.empty());
        }
    }
    EXPECT_EQ(messages(), "");
}

TEST_P(ValidatedAnyhow, TakesMorePassesInCellsWithoutAMessage) {
    // Each candidate is blocked by the next one only, which is earlier.
    const Field field = tests::constant_field(1, 1);
    const Plan plan = tests::cells_plan(field, 1, 5, Metric::min, Boundary::box, 1, 40);
    vulkan::Trial trial;
    trial.validation = &validation_;
    Snapshot scene = tests::empty_memory(plan);
    constexpr std::uint32_t kChain = 40;
    std::vector<Candidate> candidates;
    for (std::uint32_t i = 0; i < kChain; ++i) candidates.push_back({2, 4 * i, 2, kChain - 1 - i});
    tests::set_candidates(plan, candidates, scene);
    const auto backend = vulkan::make_backend(plan, {}, {}, trial);

    backend->restore(scene);
    backend->admit();
    backend->subtract();
    const std::size_t admitted = backend->finish_round().samples.size();

    EXPECT_EQ(admitted, kChain / 2);
    EXPECT_NE(backend->snapshot().bits, scene.bits);
    EXPECT_EQ(messages(), "");
}

using ValidatedCalls = Validated;
INSTANTIATE_TEST_SUITE_P(Vulkan, ValidatedCalls, testing::Values(Checks::core_and_synchronization),
                         name_of_checks);

TEST_P(ValidatedCalls, TellOfACopyBeyondTheEnd) {
    Engine engine("", &validation_);
    const Buffer small = engine.allocate(Engine::Memory::device, 64);
    const Buffer large = engine.allocate(Engine::Memory::device, 128);
    engine.copy(large, small, 128);
    EXPECT_NE(messages().find("VUID-vkCmdCopyBuffer"), std::string::npos) << messages();
}

TEST_P(ValidatedCalls, TellOfAMissingBarrier) {
    Engine engine("", &validation_);
    const Buffer a = engine.allocate(Engine::Memory::device, 64);
    const Buffer b = engine.allocate(Engine::Memory::device, 64);
    engine.fill(a, 1, 64);
    engine.copy(a, b, 64);
    EXPECT_NE(messages().find("SYNC-HAZARD-READ-AFTER-WRITE"), std::string::npos) << messages();
}

using ValidatedShaders = Validated;
INSTANTIATE_TEST_SUITE_P(Vulkan, ValidatedShaders, testing::Values(Checks::gpu_assisted),
                         name_of_checks);

TEST_P(ValidatedShaders, TellOfAReadBeyondTheEnd) {
    Engine engine("", &validation_);
    const auto kernel = engine.make_kernel(vulkan::embedded_programs().grow);
    const Buffer counts = engine.allocate(Engine::Memory::device, 64);
    const Buffer small = engine.allocate(Engine::Memory::device, 64);
    const Buffer large = engine.allocate(Engine::Memory::device, 4096);
    engine.fill(counts, 1, 64);
    engine.barrier();
    vulkan::GrowArguments arguments{};
    arguments.g.capacity = 16;
    arguments.end_line = 16;
    arguments.larger = 16;
    engine.dispatch(kernel, {counts, small, large}, arguments, 16);
    engine.wait();
    EXPECT_NE(messages().find("out of bounds"), std::string::npos) << messages();
}

}  // namespace
