// What is the vulkan backend's own: that its shaders do the work, its slabs, and its messages.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "backends/available.h"
#include "backends/cells_requests.h"
#include "backends/columns.h"
#include "backends/vulkan/engine.h"
#include "backends/vulkan/make_backend.h"
#include "generate.h"
#include "portable/fate.h"

namespace {

using namespace lacuna;
using vulkan::Engine;

#include "admit_all.spv.h"
#include "admit_all_in_cells.spv.h"

Request torus(double radius, Mode mode = Mode::exact) {
    Request request;
    request.mode = mode;
    request.radius = radius;
    request.boundary = Boundary::torus;
    return request;
}

// About 300 samples, whose radii differ by 3 times.
Plan cells_plan() {
    const tests::CellsRequest made = tests::cells_request("a ramp", tests::ramp_field(20, 20), 300,
                                                          10, Metric::min, Boundary::torus);
    return make_plan(made.request);
}

std::vector<Sample> samples_of(const Plan& plan, Backend& backend) {
    Observer nobody;
    return generate(plan, backend, nobody).samples;
}

std::vector<Sample> samples_of_cpu(const Plan& plan) {
    return samples_of(plan, *cpu::make_backend(plan, {}));
}

template <typename Thrown, typename Work>
std::string message_of(Work work) {
    try {
        work();
    } catch (const Thrown& error) {
        return error.what();
    }
    return "nothing was thrown";
}

class VulkanBackend : public testing::Test {
protected:
    void SetUp() override { tests::skip_or_fail_without("vulkan"); }
};

TEST_F(VulkanBackend, DoesItsWorkInFewDispatchesARound) {
    for (const Plan& plan :
         {make_plan(torus(0.05, Mode::lines)), make_plan(torus(0.05)), cells_plan()}) {
        std::uint64_t dispatches = 0;
        vulkan::Trial trial;
        trial.dispatches = &dispatches;
        const auto backend = vulkan::make_backend(plan, {}, {}, trial);
        Observer nobody;

        const Outcome outcome = generate(plan, *backend, nobody);

        EXPECT_GE(dispatches, 5 * outcome.rounds);
        EXPECT_LE(dispatches, 18 * outcome.rounds);
    }
}

TEST_F(VulkanBackend, MakesAnotherSetWithAnotherShader) {
    for (const Mode mode : {Mode::lines, Mode::exact}) {
        Request request = torus(0.05, mode);
        request.limit = 100;
        const Plan plan = make_plan(request);
        vulkan::Trial trial;
        trial.programs = vulkan::embedded_programs();
        trial.programs->admit.spirv = admit_all_spirv;

        EXPECT_NE(samples_of(plan, *vulkan::make_backend(plan, {}, {}, trial)),
                  samples_of_cpu(plan));
    }
}

TEST_F(VulkanBackend, MakesAnotherSetInCellsWithAnotherShader) {
    const Plan plan = cells_plan();
    vulkan::Trial trial;
    trial.programs = vulkan::embedded_programs();
    EXPECT_EQ(samples_of(plan, *vulkan::make_backend(plan, {}, {}, trial)), samples_of_cpu(plan));
    trial.programs->admit_in_cells.spirv = admit_all_in_cells_spirv;

    EXPECT_NE(samples_of(plan, *vulkan::make_backend(plan, {}, {}, trial)), samples_of_cpu(plan));
}

TEST_F(VulkanBackend, MakesTheSameSetFromManySlabs) {
    for (const Mode mode : {Mode::lines, Mode::exact}) {
        const Plan plan = make_plan(torus(0.02, mode));
        const std::uint64_t line_bytes = first_capacity(plan) * sizeof(Span);
        for (const std::uint64_t lines : {1u, 7u, 100u, plan.lines - 1}) {
            const device::Tuning tuning{lines * line_bytes};
            ASSERT_GT(
                device::share_out(plan.lines, first_capacity(plan), lines * line_bytes).size(), 1u);
            EXPECT_EQ(samples_of(plan, *vulkan::make_backend(plan, {}, tuning)),
                      samples_of_cpu(plan))
                << lines << " lines a slab";
        }
    }
}

TEST_F(VulkanBackend, ServesSpansBeyondTheLargestBufferOfManyDevices) {
    Request request = torus(0.001, Mode::lines);
    request.lines_per_radius = 40;
    request.limit = 200'000;
    const Plan plan = make_plan(request);
    constexpr std::uint64_t kSmallestRange = std::uint64_t{128} << 20;
    ASSERT_GT(std::uint64_t{plan.lines} * first_capacity(plan) * sizeof(Span), kSmallestRange);

    EXPECT_EQ(samples_of(plan, *vulkan::make_backend(plan, {}, {kSmallestRange})),
              samples_of_cpu(plan));
}

// No samples anywhere: every box is halved, and all of both halves is kept.
TEST_F(VulkanBackend, MakesRoomForMoreBoxesThanThereWere) {
    const Plan plan = make_plan(torus(0.02));
    Snapshot scene;
    scene.capacity = 1;
    scene.grid.assign(std::size_t{plan.grid_columns} * plan.grid_rows, {NO_SAMPLE, NO_SAMPLE});
    scene.box_width = plan.strip_width;
    for (std::uint32_t line = 0; line < plan.lines; ++line)
        for (std::uint32_t y = 0; y < 20; ++y)
            scene.boxes.push_back({line * plan.strip_width, 2 * y, 2 * y + 1});
    const auto backend = vulkan::make_backend(plan, {});
    backend->restore(scene);

    backend->refine(true);

    const std::vector<Box> boxes = backend->snapshot().boxes;
    ASSERT_EQ(boxes.size(), 2 * scene.boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        Box half = scene.boxes[i / 2];
        half.x += i % 2 == 0 ? 0 : plan.strip_width / 2;
        ASSERT_EQ(boxes[i], half) << "box " << i;
    }
    EXPECT_EQ(backend->finish_round().free_lengths.size(), boxes.size());
}

TEST_F(VulkanBackend, ListsADeviceThatItCanUse) {
    const std::vector<DeviceEntry> devices = vulkan::list_devices();
    const auto usable = std::find_if(devices.begin(), devices.end(),
                                     [](const DeviceEntry& e) { return e.unusable.empty(); });
    ASSERT_NE(usable, devices.end());
    EXPECT_FALSE(usable->name.empty());
    EXPECT_TRUE(usable->has_int64);
    EXPECT_GE(usable->largest_buffer_bytes, std::uint64_t{128} << 20);
    EXPECT_GT(usable->memory_bytes, 0u);
}

TEST_F(VulkanBackend, NamesTheDevicesWhenTheOneAskedForIsMissing) {
    const Plan plan = make_plan(torus(0.05));
    const std::string message = message_of<Unavailable>([&] {
        vulkan::make_backend(plan, Placement{"no such device", 0});
    });
    EXPECT_NE(message.find("no such device"), std::string::npos) << message;
    EXPECT_NE(message.find(vulkan::list_devices().front().name), std::string::npos) << message;
}

TEST_F(VulkanBackend, SaysThatNoDriverIsInstalled) {
    for (const char* name : {"VK_DRIVER_FILES", "VK_ICD_FILENAMES"}) {
        if (std::getenv(name) != nullptr) GTEST_SKIP() << name << " is set";
        setenv(name, "/no/such/driver.json", 1);
    }
    const std::string message =
        message_of<Unavailable>([] { vulkan::make_backend(make_plan(torus(0.05)), {}); });
    const std::vector<DeviceEntry> devices = vulkan::list_devices();
    for (const char* name : {"VK_DRIVER_FILES", "VK_ICD_FILENAMES"}) unsetenv(name);

    EXPECT_NE(message.find("driver"), std::string::npos) << message;
    for (const DeviceEntry& entry : devices) EXPECT_NE(entry.unusable, "") << entry.name;
}

TEST_F(VulkanBackend, NamesTheCallAndTheResultWhenTheDeviceFails) {
    Engine engine("", nullptr);
    const std::string message = message_of<DeviceError>(
        [&] { engine.allocate(Engine::Memory::device, std::uint64_t{1} << 50); });
    EXPECT_NE(message.find(engine.device().name), std::string::npos) << message;
    EXPECT_NE(message.find("vk"), std::string::npos) << message;
    EXPECT_NE(message.find("Error"), std::string::npos) << message;
}

TEST_F(VulkanBackend, RefusesLatticesBeyondTheLargestBuffer) {
    const std::uint64_t largest = Engine("", nullptr).device().largest_buffer_bytes;
    const Field field = tests::constant_field(1, 1);
    Request request;
    request.mode = Mode::cells;
    request.field = &field;
    request.scale = 20.0 / (1 << 17);
    request.lines_per_radius = 20;
    const Plan plan = make_plan(request);
    if (largest >= std::uint64_t{1} << 31) GTEST_SKIP() << "the largest lattice has 2 GiB";
    const std::string message = message_of<Unavailable>([&] { vulkan::make_backend(plan, {}); });
    EXPECT_NE(message.find("the request needs a buffer of 2.15 GB, and its largest has"),
              std::string::npos)
        << message;
}

TEST_F(VulkanBackend, RefusesRoundsBeyondTheLargestBuffer) {
    Request request = torus(0.05);
    request.round_size = std::uint64_t{1} << 40;
    const std::string message =
        message_of<BadRequest>([&] { vulkan::make_backend(make_plan(request), {}); });
    EXPECT_NE(message.find("round-size 1099511627776: must be at most"), std::string::npos)
        << message;
}

}  // namespace
