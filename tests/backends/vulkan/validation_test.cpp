// The backend under Vulkan's validation layer; and planted misuse, which the layer must report.
#include <gtest/gtest.h>

#include <mutex>
#include <string>
#include <vector>

#include "backends/available.h"
#include "backends/cells_requests.h"
#include "backends/cells_scenes.h"
#include "backends/columns.h"
#include "backends/device/kernels.h"
#include "backends/vulkan/device.h"
#include "backends/vulkan/vulkan_backend.h"
#include "portable/status.h"
#include "sampling/generate.h"
#include "space/meshes.h"
#include "space/plan.h"
#include "space/portion.h"

namespace {

using namespace lacuna;
using device::Buffer;
using vulkan::Checks;

// For each device, version 1.4.309 of the layer warns which features its GPU-assisted checks turn
// on, and that ray queries are not checked if the device has none.
bool is_about_the_checks_themselves(const std::string& message) {
    const std::string begin =
        "WARNING-GPU-Assisted-Validation: vkCreateDevice(): Internal Warning: ";
    return message.starts_with(begin + "Adding a VkPhysicalDevice") ||
           message.starts_with(begin + "Ray Query validation option was enabled, but");
}

class Validated : public testing::TestWithParam<Checks> {
protected:
    void SetUp() override {
        tests::skip_or_fail_without("vulkan");
        if (IsSkipped() || HasFatalFailure()) return;
        try {
            vulkan::open_queue({}, {{}, &validation_});
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
                                             if (is_about_the_checks_themselves(message)) return;
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
            request.domain.boundary = boundary;
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
    scene.grid.assign(std::size_t{plan.grid().columns} * plan.grid().rows, {NO_SAMPLE, NO_SAMPLE});
    scene.box_width = plan.strip_width;
    for (std::uint32_t y = 0; y < 2000; ++y)
        scene.boxes.push_back({0, plan.strip_width, 2 * y, 2 * y + 1});
    const auto backend = vulkan::make_backend(plan, {}, {}, trial);

    backend->restore(scene);
    backend->refine(true);

    EXPECT_EQ(backend->finish_round().free_lengths.size(), 4000u);
    EXPECT_EQ(messages(), "");
}

TEST_P(ValidatedAnyhow, GrowsAndTakesMorePassesWithoutAMessage) {
    // Each candidate is covered only by the next one, which is earlier. So they are decided one by
    // one, in more passes than a round has. There is memory for only one span a line.
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
    scene.statuses.assign(scene.candidates.size(), 0);
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
    // Each candidate is blocked only by the next one, which is earlier.
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

// Leaves out the GPU-assisted checks, for which lavapipe would compile these shaders for minutes.
TEST_P(ValidatedCalls, MakesSetsWithARadiusFieldWithoutAMessage) {
    const Field disks = tests::noise_field(12, 9, 7);
    Mask mask{3, 2, {1, 1, 0, 1, 1, 1}};
    const std::vector<Point> keep = {{0.1, 0.1}};
    Request request;
    request.scale = 0.03;
    request.places.mask = &mask;
    request.keep = keep;
    vulkan::Trial trial;
    trial.validation = &validation_;
    for (const Field& field : {disks, tests::stretched_at_random(disks, 4, 8)}) {
        request.field = &field;
        const Plan plan = make_plan(request);
        Observer nobody;
        EXPECT_FALSE(
            generate(plan, *vulkan::make_backend(plan, {}, {}, trial), nobody).samples.empty());
        EXPECT_EQ(messages(), "");
    }
}

TEST_P(ValidatedCalls, MakesSetsInSpaceWithoutAMessage) {
    const Mesh mesh = tests::soup(20, 3);
    vulkan::Trial trial;
    trial.validation = &validation_;
    for (const SpaceRequest& request :
         {SpaceRequest{.mesh = &mesh, .radius = 0.05}, SpaceRequest{.radius = 0.2, .seed = 3}}) {
        const Plan plan = space::CheckedRequest(request).plan(*request.radius, ~std::uint64_t{0});
        std::size_t count = 0;
        Observer nobody;
        generate<space::SpaceSample>(plan, *vulkan::make_space_backend(plan, {}, trial), nobody,
                                     [&](auto samples) { count += samples.size(); });
        EXPECT_GT(count, 10u);
        EXPECT_EQ(messages(), "");
    }
}

TEST_P(ValidatedCalls, TellOfACopyBeyondTheEnd) {
    const auto queue = vulkan::open_queue({}, {{}, &validation_});
    const Buffer small = queue->make(64);
    const std::vector<std::byte> bytes(128);
    queue->upload(small, bytes, 0);
    EXPECT_NE(messages().find("VUID-vkCmdCopyBuffer"), std::string::npos) << messages();
}

// The queue puts a barrier before every command: this test records two itself, without one.
TEST_P(ValidatedCalls, TellOfAMissingBarrier) {
    const auto instance = std::make_shared<const vulkan::Instance>(&validation_);
    const vulkan::Device device(instance, vulkan::choose_device(*instance, ""), &validation_);
    const vk::raii::Device& handle = device.handle();
    const vk::raii::CommandPool pool(handle, vk::CommandPoolCreateInfo({}, device.family()));
    const vk::raii::CommandBuffers all(handle, {*pool, vk::CommandBufferLevel::ePrimary, 1});
    const vk::raii::CommandBuffer& commands = all.front();
    const auto usage =
        vk::BufferUsageFlagBits::eTransferSrc | vk::BufferUsageFlagBits::eTransferDst;
    const vk::raii::Buffer a(handle, vk::BufferCreateInfo({}, 64, usage));
    const vk::raii::Buffer b(handle, vk::BufferCreateInfo({}, 64, usage));
    const vk::raii::DeviceMemory memory(handle, vk::MemoryAllocateInfo(4096, 0));
    a.bindMemory(*memory, 0);
    b.bindMemory(*memory, 1024);
    commands.begin(vk::CommandBufferBeginInfo());
    commands.fillBuffer(*a, 0, 64, 1);
    commands.copyBuffer(*a, *b, vk::BufferCopy(0, 0, 64));
    EXPECT_NE(messages().find("SYNC-HAZARD-READ-AFTER-WRITE"), std::string::npos) << messages();
}

using ValidatedShaders = Validated;
INSTANTIATE_TEST_SUITE_P(Vulkan, ValidatedShaders, testing::Values(Checks::gpu_assisted),
                         name_of_checks);

TEST_P(ValidatedShaders, TellOfAReadBeyondTheEnd) {
    const auto queue = vulkan::open_queue({}, {{}, &validation_});
    device::Memory memory;
    memory.span_counts = queue->make(64);
    memory.spans = queue->make(64);
    memory.new_spans = queue->make(4096);
    queue->fill(memory.span_counts, 1, 16);
    portable::SlabArguments arguments{};
    arguments.g.capacity = 16;
    arguments.end_tile = 16;
    arguments.larger = 16;
    device::launch<device::kernels::grow>(*queue, memory, arguments, 16);
    queue->wait();
    EXPECT_NE(messages().find("out of bounds"), std::string::npos) << messages();
}

}  // namespace
